// NRRD: a text header with the voxels in the same file (.nrrd) or in others (.nhdr). See
// http://teem.sourceforge.net/nrrd/format.html
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/Formats/NrrdAxes.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Packed/KeptInput.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/Rescale.h"
#include "Readers/SegmentOverlap.h"
#include "Readers/Times.h"
#include "Readers/VolumeFile.h"
#include "Readers/VoxelFile.h"
#include "Readers/VoxelLayout.h"

#include <vtkDataArray.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace varimarch
{
namespace
{

/// Sign changes that convert a named space to LPS; nothing for spaces without patient, and for
/// those of which only the number of dimensions is known.
std::optional<glm::dvec3> SignsOfSpace(const NrrdHeader& header)
{
  const std::string name = LowerCase(header.fields.Value({ "space" }));
  // A space with time has a fourth dimension, which is not read.
  for (const std::string& time : { std::string(""), std::string("t"), std::string("-time") })
  {
    for (const auto& [shortName, longName, signs] :
      { std::tuple("lps", "left-posterior-superior", glm::dvec3(1, 1, 1)),
        std::tuple("rps", "right-posterior-superior", glm::dvec3(-1, 1, 1)),
        std::tuple("las", "left-anterior-superior", glm::dvec3(1, -1, 1)),
        std::tuple("ras", "right-anterior-superior", glm::dvec3(-1, -1, 1)) })
    {
      if (name == shortName + time || name == longName + time)
      {
        return signs;
      }
    }
    for (const char* const other : { "scanner-xyz", "3d-right-handed", "3d-left-handed" })
    {
      if (name == other + time)
      {
        return std::nullopt;
      }
    }
  }
  if (!name.empty())
  {
    FailToRead(header.path, "a space such as left-posterior-superior", Quoted(name));
  }
  return std::nullopt;
}

/// The first three numbers of a vector; a space of two dimensions is a plane.
glm::dvec3 InSpace(const NrrdHeader& header, const std::string& what, const std::string& text)
{
  const std::vector<double> numbers = NrrdVector(header, what, text);
  if (numbers.size() < 2 || numbers.size() > 4)
  {
    FailToRead(header.path, "2 to 4 numbers for the " + what, Quoted(text));
  }
  return { numbers[0], numbers[1], numbers.size() > 2 ? numbers[2] : 0.0 };
}

/// The number of an axis in a field; NaN, as in the file, if it is not known.
double NumberOfAxis(
  const NrrdHeader& header, const std::string& key, std::size_t axis, std::size_t rank)
{
  const auto parts = NrrdPartsPerAxis(header, { key }, rank);
  return parts.empty() ? std::nan("")
                       : NumberFromText(header.path, "numbers as " + key, parts[axis]);
}

/// Length of a unit in a field with one for each axis [mm]; adds a warning for an unknown unit.
double MmPerUnitOfAxis(
  const std::vector<std::string>& units, std::size_t axis, std::vector<std::string>& warnings)
{
  std::string unit = axis < units.size() ? units[axis] : "";
  unit.erase(std::remove(unit.begin(), unit.end(), '"'), unit.end());
  return MmPerUnitOrWarn(unit, warnings);
}

/// Placement of an axis by its own fields, without a space.
struct AxisLine
{
  double step = 1.0;
  double first = 0.0; ///< position of the first sample
};

/// Follows teem: where the file does not say otherwise, samples are at the centres of cells, and
/// the axis begins at the edge of the first one.
AxisLine LineOfAxis(const NrrdHeader& header, std::size_t axis, std::size_t size, std::size_t rank)
{
  const auto centers = NrrdPartsPerAxis(header, { "centers", "centerings" }, rank);
  const bool isNode = !centers.empty() && LowerCase(centers[axis]) == "node";
  const double least = NumberOfAxis(header, "axismins", axis, rank);
  const double most = NumberOfAxis(header, "axismaxs", axis, rank);
  const double spacing = NumberOfAxis(header, "spacings", axis, rank);
  const double intervals = isNode ? double(size) - 1.0 : double(size);
  AxisLine line;
  line.step = std::isfinite(spacing)                          ? spacing
    : std::isfinite(least) && std::isfinite(most) && size > 1 ? (most - least) / intervals
                                                              : 1.0;
  line.first = std::isfinite(least) ? least + (isNode ? 0.0 : 0.5 * line.step) : 0.0;
  return line;
}

/// The geometry in the file's space and unit.
ImageGeometry GeometryInSpace(const NrrdHeader& header, const NrrdAxes& axes)
{
  const std::size_t rank = axes.sizes.size();
  const auto directions = NrrdPartsPerAxis(header, { "spacedirections" }, rank);
  const std::string origin = header.fields.Value({ "spaceorigin" });
  ImageGeometry geometry;
  for (int i = 0; i < int(axes.spatial.size()); ++i)
  {
    const std::size_t axis = axes.spatial[i];
    const AxisLine line = LineOfAxis(header, axis, std::size_t(axes.sizes[axis]), rank);
    geometry.axesMm[i] = directions.empty() ? geometry.axesMm[i] * line.step
                                            : InSpace(header, "space directions", directions[axis]);
    geometry.originMm[i] = directions.empty() ? line.first : 0.0;
  }
  if (axes.spatial.size() == 2)
  {
    const glm::dvec3 normal = glm::cross(geometry.axesMm[0], geometry.axesMm[1]);
    geometry.axesMm[2] = glm::length(normal) > 0.0 ? glm::normalize(normal) : glm::dvec3(0, 0, 1);
  }
  if (!origin.empty() && !NrrdVector(header, "space origin", origin).empty())
  {
    geometry.originMm = InSpace(header, "space origin", origin);
  }
  return geometry;
}

/// Determines the geometry. Adds warnings if the file does not state the patient's orientation, or
/// states a unit that is not known.
/// @throws std::runtime_error for an unknown space or invalid numbers
ImageGeometry GeometryOf(
  const NrrdHeader& header, const NrrdAxes& axes, std::vector<std::string>& warnings)
{
  ImageGeometry geometry = GeometryInSpace(header, axes);
  const auto spaceUnits = NrrdParts(header.fields.Value({ "spaceunits" }));
  const auto axisUnits = spaceUnits.empty()
    ? NrrdPartsPerAxis(header, { "units" }, axes.sizes.size())
    : std::vector<std::string>();
  glm::dvec3 mmPerSpaceUnit(1.0);
  for (int i = 0; i < int(axes.spatial.size()); ++i)
  {
    const double mmPerAxisUnit = MmPerUnitOfAxis(axisUnits, axes.spatial[i], warnings);
    geometry.axesMm[i] *= mmPerAxisUnit;
    geometry.originMm[i] *= mmPerAxisUnit;
  }
  for (int i = 0; i < 3; ++i)
  {
    mmPerSpaceUnit[i] = MmPerUnitOfAxis(spaceUnits, std::size_t(i), warnings);
  }
  const std::optional<glm::dvec3> signs = SignsOfSpace(header);
  if (!signs)
  {
    warnings.push_back(UnknownSides);
  }
  return InLps(geometry, signs.value_or(glm::dvec3(1.0)) * mmPerSpaceUnit, 1.0);
}

/// A segment, and the layer that its voxels have its label in.
struct LayeredSegment
{
  LabelledSegment segment;
  std::int64_t layer;
};

class SegmentPairs
{
public:
  SegmentPairs(const NrrdHeader& header, int segment)
    : header(header)
    , prefix("Segment" + std::to_string(segment) + "_")
  {
  }

  std::string Text(const std::string& key) const
  {
    const auto pair = this->header.pairs.find(this->prefix + key);
    return pair == this->header.pairs.end() ? std::string() : pair->second;
  }

  std::int64_t IntegerOr(const std::string& key, std::int64_t otherwise) const
  {
    const std::string text = this->Text(key);
    return text.empty()
      ? otherwise
      : IntegerFromText(this->header.path, "a whole number as " + this->prefix + key, text);
  }

  std::optional<glm::dvec3> Colour() const
  {
    const std::string text = this->Text("Color");
    if (text.empty())
    {
      return std::nullopt;
    }
    const auto rgb = NumbersFromText(this->header.path, this->prefix + "Color", text, 3);
    return glm::dvec3(rgb[0], rgb[1], rgb[2]);
  }

private:
  const NrrdHeader& header;
  std::string prefix;
};

bool HasPairs(const NrrdHeader& header, int segment)
{
  const std::string prefix = "Segment" + std::to_string(segment) + "_";
  const auto first = header.pairs.lower_bound(prefix);
  return first != header.pairs.end() && first->first.compare(0, prefix.size(), prefix) == 0;
}

/// The segments in their order. Files of before 2020 have a layer for each segment, and do not say
/// so.
std::vector<LayeredSegment> SegmentsOf(const NrrdHeader& header, std::int64_t layerCount)
{
  std::vector<LayeredSegment> segments;
  for (int i = 0; HasPairs(header, i); ++i)
  {
    const SegmentPairs pairs(header, i);
    const std::int64_t layer = pairs.IntegerOr("Layer", layerCount > 1 ? i : 0);
    if (layer < 0 || layer >= layerCount)
    {
      FailToRead(header.path,
        "Segment" + std::to_string(i) + " in one of " + std::to_string(layerCount) +
          " layers, counted from 0",
        "layer " + std::to_string(layer));
    }
    const auto label = int(pairs.IntegerOr("LabelValue", 1));
    segments.push_back({ { label, pairs.Text("Name"), pairs.Colour() }, layer });
  }
  return segments;
}

/// For each layer, the numbers of the segments of its labels.
using NumbersOfLayers = std::vector<std::map<int, std::uint16_t>>;

/// Puts the segments of one layer of some voxels over those of the layers before.
template <class Value>
void PutLayer(const Value* values, std::size_t layer, const NumbersOfLayers& layers,
  std::vector<std::uint16_t>& numbers)
{
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    const auto found = layers[layer].find(int(values[i * layers.size() + layer]));
    numbers[i] = found == layers[layer].end() ? std::uint16_t(0) : found->second;
  }
}

void MergeLayers(const NumbersOfLayers& layers, SegmentOverlap& overlap, Volume& volume)
{
  const int* const size = volume.image->GetDimensions();
  const auto merged = AllocatedImage({ { size[0], size[1], size[2] }, VTK_UNSIGNED_SHORT });
  auto* const voxels = static_cast<std::uint16_t*>(merged->GetScalarPointer());
  std::fill_n(voxels, merged->GetNumberOfPoints(), std::uint16_t(0));
  std::vector<std::uint16_t> numbers(std::size_t(size[0]) * std::size_t(size[1]));
  for (int slice = 0; slice < size[2]; ++slice)
  {
    const void* const begin = volume.image->GetScalarPointer(0, 0, slice);
    for (std::size_t layer = 0; layer < layers.size(); ++layer)
    {
      switch (volume.image->GetScalarType())
      {
        vtkTemplateMacro(PutLayer(static_cast<const VTK_TT*>(begin), layer, layers, numbers));
      }
      overlap.Put(numbers, voxels + std::size_t(slice) * numbers.size());
    }
  }
  volume.image = merged;
}

// Segmentations of 3D Slicer (.seg.nrrd): label maps whose key/value pairs describe the segments.
// Segments that overlap are in several layers, along a list axis.

/// True if a header describes segments.
bool HoldsSegments(const NrrdHeader& header)
{
  return HasPairs(header, 0);
}

/// The axes of a segmentation: layers are the components of a voxel.
NrrdAxes LayersAsComponents(const NrrdAxes& axes)
{
  NrrdAxes layered = axes;
  layered.planar = axes.planar || (axes.volumeCount > 1 && !axes.areAlternating);
  layered.componentCount *= axes.volumeCount;
  layered.volumeCount = 1;
  layered.areAlternating = false;
  return layered;
}

/// Takes the segments, and makes labels of the layers: with several layers a voxel's value is the
/// number of its segment, counted from 1. Where segments overlap, the later one wins.
void TakeSegments(const NrrdHeader& header, Volume& volume)
{
  const std::int64_t layerCount = volume.image->GetNumberOfScalarComponents();
  std::vector<LayeredSegment> segments = SegmentsOf(header, layerCount);
  NumbersOfLayers layers(static_cast<std::size_t>(layerCount));
  std::vector<LabelledSegment> described;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    LabelledSegment& segment = segments[i].segment;
    if (layerCount > 1)
    {
      layers[std::size_t(segments[i].layer)][segment.value] = std::uint16_t(i + 1);
      segment.value = int(i + 1);
    }
    described.push_back(segment);
  }
  if (layerCount > 1)
  {
    SegmentOverlap overlap;
    MergeLayers(layers, overlap, volume);
    overlap.Warn(described, volume.warnings);
  }
  volume.segments = described;
}

/// Number of bytes or lines to skip; 0 if the field is missing, VoxelFile::FromEnd for -1.
std::int64_t Skip(const NrrdHeader& header, const std::string& key)
{
  const std::string value = header.fields.Value({ key });
  const std::int64_t skip =
    value.empty() ? 0 : IntegerFromText(header.path, "a number as " + key, value);
  if (skip < VoxelFile::FromEnd)
  {
    FailToRead(header.path, "at least -1 as " + key, value);
  }
  return skip;
}

void SetEncoding(const NrrdHeader& header, VoxelFile& file)
{
  const std::string encoding = LowerCase(header.fields.Value({ "encoding" }));
  if (encoding == "gzip" || encoding == "gz")
  {
    file.compression = Compression::Deflate;
  }
  else if (encoding == "bzip2" || encoding == "bz2")
  {
    file.compression = Compression::Other;
  }
  else if (encoding == "hex")
  {
    file.compression = Compression::Hexadecimal;
  }
  else if (encoding == "txt" || encoding == "text" || encoding == "ascii")
  {
    file.encoding = VoxelEncoding::Text;
  }
  else if (encoding != "raw")
  {
    FailToRead(header.path, "the encoding raw, gzip, bzip2, hex or ascii", Quoted(encoding));
  }
}

VoxelFile VoxelFileOf(const NrrdHeader& header)
{
  VoxelFile file;
  SetEncoding(header, file);
  file.bigEndian = LowerCase(header.fields.Value({ "endian" })) == "big";
  if (header.fields.Has("datafile"))
  {
    file.paths = DataFiles(header.path, header.fields.Value({ "datafile" }), header.listedFiles);
  }
  else
  {
    file.paths = { header.path };
    file.fileOffset = std::int64_t(header.end);
  }

  file.lineSkip = Skip(header, "lineskip");
  file.dataOffset = Skip(header, "byteskip");
  return file;
}

}

Volume ReadNrrd(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  Volume volume;
  const NrrdHeader header = ReadNrrdHeader(path);
  const bool holdsSegments = HoldsSegments(header);
  const NrrdAxes axes = holdsSegments ? LayersAsComponents(AxesOf(header)) : AxesOf(header);
  TakeTimes(path, TimesOf(header, axes), options, volume);
  const VoxelLayout layout = LayoutOf(header, axes);
  const ImageGeometry geometry = GeometryOf(header, axes, volume.warnings);
  VoxelFile file = VoxelFileOf(header);
  file.planar = axes.planar;
  file.volumeCount = axes.volumeCount;
  file.volume = options.time;
  file.kept = StreamOf(options);
  file.alternation = axes.areAlternating ? 1 : 0;
  file.conversion = holdsSegments ? "joined to segments" : "";
  file.mapping = MappingOf(options);
  const bool needsByteOrder =
    file.encoding == VoxelEncoding::Binary && vtkDataArray::GetDataTypeSize(layout.scalarType) > 1;
  if (needsByteOrder && !header.fields.Has("endian"))
  {
    volume.warnings.push_back(UnknownByteOrder);
  }
  volume.image = ReadVoxels(file, layout, progress);
  if (holdsSegments)
  {
    TakeSegments(header, volume);
  }
  else if (axes.areComplex)
  {
    TakeMagnitude("The numbers are complex", volume);
  }
  PlaceImage(path, geometry, volume.image);
  return volume;
}

}
