#include "Scene/VolumeWriters/WrittenImage.h"
#include "Scene/VolumeWriters/ZarrLevels.h"

#include <vtkDataArray.h>

#include <utility>

namespace varimarch
{

namespace
{

/// A type in NumPy's words, such as "<u2".
std::string NumPyType(int scalarType)
{
  const int valueBytes = vtkDataArray::GetDataTypeSize(scalarType);
  const bool isReal = scalarType == VTK_FLOAT || scalarType == VTK_DOUBLE;
  const bool isSigned = vtkDataArray::GetDataTypeMin(scalarType) < 0.0;
  const std::string order = valueBytes == 1 ? "|" : IsBigEndianMachine() ? ">" : "<";
  return order + (isReal ? "f" : isSigned ? "i" : "u") + std::to_string(valueBytes);
}

/// The transforms of a level. A coarse voxel lies in the middle of the fine ones that it covers.
nlohmann::ordered_json DatasetJson(
  const ZarrInput& input, const std::vector<ZarrLevel>& levels, std::size_t level)
{
  glm::dvec3 factor(1.0);
  for (std::size_t i = 0; i <= level; ++i)
  {
    const ZarrIndex& factors = levels[i].factors;
    factor *= glm::dvec3(double(factors[0]), double(factors[1]), double(factors[2]));
  }
  const glm::dvec3 scale = input.spacingMm * factor;
  const glm::dvec3 shift = input.isLabels ? glm::dvec3(0.0) : 0.5 * (factor - 1.0);
  const glm::dvec3 place = input.originMm + input.spacingMm * shift;
  nlohmann::ordered_json scales = { scale.z, scale.y, scale.x };
  nlohmann::ordered_json places = { place.z, place.y, place.x };
  if (input.componentCount > 1)
  {
    scales.insert(scales.begin(), 1.0);
    places.insert(places.begin(), 0.0);
  }
  return { { "path", std::to_string(level) },
    { "coordinateTransformations",
      { { { "type", "scale" }, { "scale", scales } },
        { { "type", "translation" }, { "translation", places } } } } };
}

/// The range of values to show, for each component.
nlohmann::ordered_json ChannelsJson(const ZarrInput& input)
{
  const auto [width, middle] = *input.windowLevel;
  const double from = middle - 0.5 * width;
  const double to = middle + 0.5 * width;
  const nlohmann::ordered_json window = { { "min", from }, { "max", to }, { "start", from },
    { "end", to } };
  nlohmann::ordered_json channels = nlohmann::ordered_json::array();
  for (int component = 0; component < input.componentCount; ++component)
  {
    channels.push_back({ { "active", component == 0 }, { "color", "FFFFFF" },
      { "label", std::to_string(component) }, { "window", window } });
  }
  return channels;
}

}

nlohmann::ordered_json ZarrArrayJson(const ZarrInput& input, const ZarrLevel& level)
{
  const ZarrIndex& size = level.dimensions;
  nlohmann::ordered_json shape = { size[2], size[1], size[0] };
  nlohmann::ordered_json chunks = { ZarrChunkSide, ZarrChunkSide, ZarrChunkSide };
  if (input.componentCount > 1)
  {
    shape.insert(shape.begin(), input.componentCount);
    chunks.insert(chunks.begin(), 1);
  }
  return { { "zarr_format", 2 }, { "shape", shape }, { "chunks", chunks },
    { "dtype", NumPyType(input.scalarType) },
    { "compressor",
      { { "id", "blosc" }, { "cname", "zstd" }, { "clevel", 5 }, { "shuffle", 1 },
        { "blocksize", 0 } } },
    { "fill_value", 0 }, { "order", "C" }, { "filters", nullptr }, { "dimension_separator", "/" } };
}

nlohmann::ordered_json ZarrAttributes(const ZarrInput& input, const std::vector<ZarrLevel>& levels)
{
  nlohmann::ordered_json axes = nlohmann::ordered_json::array();
  if (input.componentCount > 1)
  {
    axes.push_back({ { "name", "c" }, { "type", "channel" } });
  }
  const std::pair<const char*, const char*> spatial[] = { { "z", "inferior-to-superior" },
    { "y", "anterior-to-posterior" }, { "x", "right-to-left" } };
  for (const auto& [name, direction] : spatial)
  {
    nlohmann::ordered_json axis = { { "name", name }, { "type", "space" },
      { "unit", "millimeter" } };
    if (input.statesSides)
    {
      axis["orientation"] = { { "type", "anatomical" }, { "value", direction } };
    }
    axes.push_back(axis);
  }
  nlohmann::ordered_json datasets = nlohmann::ordered_json::array();
  for (std::size_t level = 0; level < levels.size(); ++level)
  {
    datasets.push_back(DatasetJson(input, levels, level));
  }
  nlohmann::ordered_json multiscale = { { "version", "0.4" }, { "axes", axes },
    { "datasets", datasets }, { "type", input.isLabels ? "nearest" : "mean" } };
  nlohmann::ordered_json attributes;
  attributes["multiscales"] = nlohmann::ordered_json::array({ multiscale });
  if (input.windowLevel)
  {
    attributes["omero"] = { { "channels", ChannelsJson(input) } };
  }
  return attributes;
}

}
