// MIF, the format of MRtrix: a text header with the voxels in the same file (.mif) or in another
// (.mih). See https://mrtrix.readthedocs.io/en/latest/getting_started/image_data.html
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Parsing/HeaderText.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/Rescale.h"
#include "Readers/Times.h"
#include "Readers/VoxelFile.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>

namespace varimarch
{
namespace
{

constexpr const char* mifMark = "mrtrix image";

struct MifHeader
{
  std::string path;
  HeaderFields fields;
  std::vector<std::int64_t> sizes; ///< voxels along the axes x, y, z and perhaps more
  std::vector<std::size_t> order;  ///< the axes, fastest in the file first
  std::vector<bool> isBackwards; ///< for each axis, true if its last voxel comes first in the file
};

/// The parts of a list with commas.
std::vector<std::string> Parts(std::string list)
{
  std::replace(list.begin(), list.end(), ',', ' ');
  return Words(list);
}

/// Sets the order and the directions of the axes from a text such as "-0,-1,+2".
void SetLayout(MifHeader& header)
{
  const std::string layout = header.fields.Value({ "layout" });
  const std::vector<std::string> places = Parts(layout);
  const std::size_t rank = header.sizes.size();
  header.order.assign(rank, rank);
  bool isValid = places.size() == rank;
  for (std::size_t axis = 0; isValid && axis < rank; ++axis)
  {
    const bool hasSign = places[axis].find_first_of("+-") == 0;
    const std::int64_t place =
      IntegerFromText(header.path, "whole numbers as layout", places[axis].substr(hasSign ? 1 : 0));
    isValid = place >= 0 && place < std::int64_t(rank) && header.order[std::size_t(place)] == rank;
    if (isValid)
    {
      header.order[std::size_t(place)] = axis;
      header.isBackwards.push_back(places[axis].front() == '-');
    }
  }
  if (!isValid)
  {
    FailToRead(header.path, "a layout such as +0,+1,+2 with a place for each axis", Quoted(layout));
  }
}

void SetSizes(MifHeader& header)
{
  double voxelCount = 1.0;
  for (const std::string& word : Parts(header.fields.Value({ "dim" })))
  {
    header.sizes.push_back(IntegerFromText(header.path, "whole numbers as dim", word));
    voxelCount *= double(header.sizes.back());
    // The upper bound keeps products of sizes exact.
    if (header.sizes.back() < 1 || voxelCount > 9e15)
    {
      FailToRead(header.path, "dimensions above 0 whose product is at most 9e15",
        Quoted(header.fields.Value({ "dim" })));
    }
  }
  if (header.sizes.size() < 3 || header.sizes.size() > 16)
  {
    FailToRead(header.path, "3 to 16 dimensions", std::to_string(header.sizes.size()));
  }
}

/// True if a header names another file for the voxels. MRtrix writes END only before voxels.
bool HasVoxelsElsewhere(const MifHeader& header)
{
  const std::string file = header.fields.Value({ "file" });
  return !file.empty() && file != "." && file.compare(0, 2, ". ") != 0;
}

MifHeader ReadMifHeader(const std::string& path)
{
  MifHeader header;
  header.path = path;
  HeaderLines lines(path);
  if (Trimmed(lines.Next().value_or("")) != mifMark)
  {
    FailToRead(path, std::string("a first line \"") + mifMark + '"', "another one");
  }
  std::optional<std::string> line;
  while ((line = lines.Next()) && Trimmed(*line) != "END")
  {
    const std::size_t colon = line->find(':');
    if (colon == std::string::npos)
    {
      continue;
    }
    const std::string key = LowerCase(Trimmed(line->substr(0, colon)));
    const std::string value = Trimmed(line->substr(colon + 1));
    // The matrix has one line for each of its rows.
    const bool isMore = key == "transform" && header.fields.Has(key);
    header.fields.Set(key, isMore ? header.fields.Value({ key }) + ',' + value : value);
  }
  const bool isComplete = line || (HasVoxelsElsewhere(header) && !lines.EndInALine());
  if (!isComplete)
  {
    FailToRead(
      path, "a header that ends with END, or with a line about another file", "no such line");
  }
  SetSizes(header);
  SetLayout(header);
  return header;
}

struct MifType
{
  int scalarType;
  bool bigEndian;
};

/// Parses a type such as "UInt16LE".
MifType TypeOf(const MifHeader& header)
{
  const std::string stated = header.fields.Value({ "datatype" });
  std::string name = LowerCase(stated);
  const std::string end = name.size() > 2 ? name.substr(name.size() - 2) : "";
  if (end == "le" || end == "be")
  {
    name.erase(name.size() - 2);
  }
  static const std::map<std::string, int> types = { { "int8", VTK_SIGNED_CHAR },
    { "uint8", VTK_UNSIGNED_CHAR }, { "int16", VTK_SHORT }, { "uint16", VTK_UNSIGNED_SHORT },
    { "int32", VTK_INT }, { "uint32", VTK_UNSIGNED_INT }, { "int64", VTK_TYPE_INT64 },
    { "uint64", VTK_TYPE_UINT64 }, { "float32", VTK_FLOAT }, { "float64", VTK_DOUBLE } };
  const auto type = types.find(name);
  if (type == types.end())
  {
    FailToRead(header.path, "a type of real numbers such as Int16LE or Float32LE", Quoted(stated));
  }
  return { type->second, end == "be" };
}

/// The axes of the volume, fastest in the file first.
std::vector<std::size_t> SpatialAxes(const MifHeader& header)
{
  std::vector<std::size_t> axes;
  std::copy_if(header.order.begin(), header.order.end(), std::back_inserter(axes),
    [](std::size_t axis) { return axis < 3; });
  return axes;
}

/// How the volumes lie in the file, if there are several.
void ArrangeVolumes(const MifHeader& header, VoxelFile& file)
{
  std::int64_t voxelCount = 1;
  bool isDone = false;
  for (const std::size_t axis : header.order)
  {
    const std::int64_t size = header.sizes[axis];
    const bool isOther = axis >= 3 && size > 1;
    if (isOther && (isDone || header.isBackwards[axis]))
    {
      FailToRead(header.path, "volumes whose axis runs forwards and is in one place",
        "the layout " + Quoted(header.fields.Value({ "layout" })));
    }
    if (isOther)
    {
      file.volumeCount *= size;
      file.alternation = voxelCount;
    }
    isDone = isDone || (!isOther && size > 1 && file.volumeCount > 1);
    voxelCount *= isOther ? 1 : size;
  }
  // Volumes one behind the other do not alternate, so that only the first must be there.
  file.alternation = file.alternation == voxelCount ? 0 : file.alternation;
}

VoxelFile VoxelFileOf(const MifHeader& header, bool bigEndian)
{
  const std::string value = header.fields.Value({ "file" });
  const std::size_t blank = value.find_last_of(" \t");
  const std::string name = Trimmed(value.substr(0, blank));
  VoxelFile file;
  file.paths = { name == "." ? header.path
                             : (std::filesystem::path(header.path).parent_path() / name).string() };
  file.fileOffset = blank == std::string::npos
    ? 0
    : IntegerFromText(header.path, "an offset after the file's name", value.substr(blank + 1));
  if (name.empty() || file.fileOffset < 0)
  {
    FailToRead(
      header.path, "the name of a file, or a dot for this file, and an offset", Quoted(value));
  }
  file.bigEndian = bigEndian;
  ArrangeVolumes(header, file);
  return file;
}

/// Distances of voxels along x, y and z. As MRtrix does, an unknown one becomes the mean of those
/// that are known, or 1.
glm::dvec3 SpacingMm(const MifHeader& header, Volume& volume)
{
  std::vector<std::string> words = Parts(header.fields.Value({ "vox" }));
  words.resize(3, "nan");
  glm::dvec3 spacingMm;
  double sumMm = 0.0;
  int knownCount = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    spacingMm[axis] = NumberFromText(header.path, "numbers as vox", words[std::size_t(axis)]);
    const bool isKnown = std::isfinite(spacingMm[axis]);
    sumMm += isKnown ? spacingMm[axis] : 0.0;
    knownCount += isKnown ? 1 : 0;
  }
  if (knownCount == 3)
  {
    return spacingMm;
  }
  const double usualMm = knownCount > 0 ? sumMm / knownCount : 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    spacingMm[axis] = std::isfinite(spacingMm[axis]) ? spacingMm[axis] : usualMm;
  }
  volume.warnings.push_back("The distance of voxels is not known along " +
    std::to_string(3 - knownCount) + " of 3 axes; the mean of the others is taken, or 1 mm.");
  return spacingMm;
}

/// Geometry in RAS of the axes x, y, z, each forwards. MRtrix puts the centre of a volume without
/// transform at the origin.
ImageGeometry NominalGeometry(const MifHeader& header, Volume& volume)
{
  const glm::dvec3 spacingMm = SpacingMm(header, volume);
  ImageGeometry geometry;
  for (int axis = 0; axis < 3; ++axis)
  {
    geometry.axesMm[axis] *= spacingMm[axis];
    geometry.originMm -=
      geometry.axesMm[axis] * (0.5 * double(header.sizes[std::size_t(axis)] - 1));
  }
  if (!header.fields.Has("transform"))
  {
    volume.warnings.push_back(UnknownSides);
    return geometry;
  }
  const std::vector<std::string> words = Parts(header.fields.Value({ "transform" }));
  if (words.size() < 12)
  {
    FailToRead(header.path, "12 numbers as transform", std::to_string(words.size()));
  }
  glm::dmat3 direction;
  for (int i = 0; i < 12; ++i)
  {
    const double number =
      NumberFromText(header.path, "numbers as transform", words[std::size_t(i)]);
    (i % 4 == 3 ? geometry.originMm : direction[i % 4])[i / 4] = number;
  }
  geometry.axesMm = direction * geometry.axesMm;
  return geometry;
}

/// Geometry in RAS of the axes in the order and direction of the file.
ImageGeometry GeometryOf(const MifHeader& header, Volume& volume)
{
  const ImageGeometry nominal = NominalGeometry(header, volume);
  ImageGeometry geometry;
  geometry.originMm = nominal.originMm;
  int stored = 0;
  for (const std::size_t axis : SpatialAxes(header))
  {
    const glm::dvec3 stepMm = nominal.axesMm[int(axis)];
    const bool isBackwards = header.isBackwards[axis];
    geometry.axesMm[stored] = isBackwards ? -stepMm : stepMm;
    geometry.originMm += isBackwards ? stepMm * double(header.sizes[axis] - 1) : glm::dvec3(0.0);
    ++stored;
  }
  return geometry;
}

/// The volumes: those of the fourth axis are times if the header has their distance, in seconds.
VolumeTimes TimesOf(const MifHeader& header, std::int64_t volumeCount)
{
  const std::vector<std::string> words = Parts(header.fields.Value({ "vox" }));
  const bool isFourth = header.sizes.size() > 3 && header.sizes[3] == volumeCount;
  return EvenTimes(
    volumeCount, 0.0, isFourth && words.size() > 3 ? NumberIn(words[3]).value_or(0.0) : 0.0);
}

Rescale RescaleOf(const MifHeader& header)
{
  const std::vector<std::string> words = Parts(header.fields.Value({ "scaling" }));
  return words.size() < 2 ? Rescale()
                          : Rescale{ NumberFromText(header.path, "numbers as scaling", words[1]),
                              NumberFromText(header.path, "numbers as scaling", words[0]) };
}

}

bool IsMif(const std::string& head)
{
  return head.compare(0, std::string(mifMark).size(), mifMark) == 0;
}

Volume ReadMif(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  const MifHeader header = ReadMifHeader(path);
  const MifType type = TypeOf(header);
  VoxelLayout layout = { {}, type.scalarType };
  std::size_t stored = 0;
  for (const std::size_t axis : SpatialAxes(header))
  {
    layout.dimensions[stored++] = header.sizes[axis];
  }
  Volume volume;
  VoxelFile file = VoxelFileOf(header, type.bigEndian);
  const ImageGeometry geometry = GeometryOf(header, volume);
  const Rescale rescale = RescaleOf(header);
  TakeTimes(path, TimesOf(header, file.volumeCount), options, volume);
  file.volume = options.time;
  volume.image = ReadVoxels(file, layout, progress);
  volume.image = Rescaled(path, volume.image, { rescale });
  PlaceImage(path, InLps(geometry, LpsFromRas, 1.0), volume.image);
  return volume;
}

}
