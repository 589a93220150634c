// The volumes that WriteZarr writes: in memory, or in a file with chunks.
#include "Scene/VolumeWriters/ZarrFolder.h"

#include "Readers/Decoder/DecodedPyramid.h"
#include "Readers/ImageFacts.h"
#include "Scene/VolumeWriters/WrittenImage.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstring>

namespace varimarch
{

namespace
{

// The levels of a file; null for files without levels.
std::shared_ptr<DecodedPyramid> PyramidOf(const FileSource& source)
{
  if (source.timeSeconds)
  {
    return nullptr; // a reader finds the time that is nearest
  }
  ReadProgress silent([](double) { return true; });
  ReadOptions options;
  options.channel = source.channel.value_or(0);
  options.time = source.time;
  return OpenPyramidAt(source.path, options, silent);
}

bool StatesSides(const std::vector<std::string>& warnings)
{
  return std::find(warnings.begin(), warnings.end(), UnknownSides) == warnings.end();
}

}

ZarrInput ZarrInputOf(const LoadedVolume& volume)
{
  const WrittenImage image("OME-Zarr", volume.image);
  const std::array<int, 3> size = image.Size();
  ZarrInput input = { { size[0], size[1], size[2] }, volume.image->GetScalarType(),
    image.ComponentCount(), image.OriginMm(), image.SpacingMm(), image.Direction() };
  input.windowLevel = volume.windowLevel;
  input.isLabels = !volume.segments.empty();
  input.statesSides = ShowsPatient(volume.image) && StatesSides(volume.warnings);
  const char* const values = image.Values();
  const auto voxelBytes = std::int64_t(image.ValueBytes()) * image.ComponentCount();
  input.read = [=](const auto& lower, const auto& upper, void* voxels)
  {
    char* to = static_cast<char*>(voxels);
    const auto rowBytes = std::size_t((upper[0] - lower[0]) * voxelBytes);
    for (std::int64_t k = lower[2]; k < upper[2]; ++k)
    {
      for (std::int64_t j = lower[1]; j < upper[1]; ++j, to += rowBytes)
      {
        const std::int64_t first = (k * size[1] + j) * size[0] + lower[0];
        std::memcpy(to, values + first * voxelBytes, rowBytes);
      }
    }
  };
  return input;
}

std::optional<ZarrInput> ChunkedInput(const FileSource& source, std::vector<std::string>& warnings)
{
  const std::shared_ptr<DecodedPyramid> pyramid = PyramidOf(source);
  if (!pyramid)
  {
    return std::nullopt;
  }
  const PyramidForm& form = pyramid->Form();
  const auto level = std::size_t(source.level.value_or(0));
  if (level >= form.levels.size())
  {
    throw std::runtime_error(source.path + ": expected a level from 0 to " +
      std::to_string(form.levels.size() - 1) + ", found " + std::to_string(level));
  }
  warnings.insert(warnings.end(), form.warnings.begin(), form.warnings.end());
  if (!form.otherChannels.empty())
  {
    warnings.push_back(form.otherChannels);
  }
  const ImageGeometry& geometry = form.geometries[level];
  ZarrInput input = { form.levels[level].dimensions, form.scalarType, 1, geometry.originMm };
  for (int axis = 0; axis < 3; ++axis)
  {
    input.spacingMm[axis] = glm::length(geometry.axesMm[axis]);
    input.direction[axis] = geometry.axesMm[axis] / input.spacingMm[axis];
  }
  if (form.windowLevel)
  {
    input.windowLevel = { form.windowLevel->window, form.windowLevel->level };
  }
  input.statesSides = StatesSides(form.warnings);
  const auto lacksChunks = std::make_shared<std::atomic<bool>>(false);
  input.lacksChunks = lacksChunks;
  input.read = [pyramid, level, lacksChunks](const auto& lower, const auto& upper, void* voxels)
  {
    ReadProgress noProgress([](double) { return true; });
    if (pyramid->ReadStored(int(level), { lower, upper }, voxels, noProgress) > 0)
    {
      *lacksChunks = true;
    }
  };
  return input;
}

}
