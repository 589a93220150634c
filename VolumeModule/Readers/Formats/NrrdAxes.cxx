#include "Readers/Formats/NrrdAxes.h"

#include "Readers/FileError.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/Times.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace varimarch
{
namespace
{

/// Parses one header line: a field, a comment, or a key/value pair.
void TakeLine(NrrdHeader& header, const std::string& line)
{
  const std::size_t colon = line.find(':');
  if (line[0] == '#')
  {
    return; // a comment
  }
  if (line.compare(std::min(colon, line.size()), 2, ":=") == 0)
  {
    header.pairs[line.substr(0, colon)] = Trimmed(line.substr(colon + 2));
    return;
  }
  if (colon == std::string::npos)
  {
    FailToRead(header.path, "a NRRD header of lines \"field: value\"", Quoted(line));
  }
  header.fields.Set(
    WithoutBlanks(LowerCase(line.substr(0, colon))), Trimmed(line.substr(colon + 1)));
}

}

std::string WithoutBlanks(std::string text)
{
  text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
  return text;
}

std::vector<std::string> NrrdParts(const std::string& line)
{
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while ((begin = line.find_first_not_of(" \t", begin)) != std::string::npos)
  {
    const char first = line[begin];
    std::size_t end = line.find_first_of(first == '(' ? ")"
        : first == '"'                                ? "\""
                                                      : " \t",
      begin + 1);
    end = end == std::string::npos ? line.size() : end + (first == '(' || first == '"' ? 1 : 0);
    parts.push_back(line.substr(begin, end - begin));
    begin = end;
  }
  return parts;
}

std::vector<std::string> NrrdPartsPerAxis(
  const NrrdHeader& header, const std::vector<std::string>& keys, std::size_t axisCount)
{
  const std::vector<std::string> parts = NrrdParts(header.fields.Value(keys));
  if (!parts.empty() && parts.size() != axisCount)
  {
    FailToRead(header.path, std::to_string(axisCount) + " values for the field " + keys.front(),
      std::to_string(parts.size()));
  }
  return parts;
}

std::vector<double> NrrdVector(
  const NrrdHeader& header, const std::string& what, const std::string& text)
{
  std::string inside = text;
  std::replace_if(
    inside.begin(), inside.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
  if (LowerCase(text) == "none" || LowerCase(Words(inside).front()) == "nan")
  {
    return {};
  }
  if (text.empty() || text.front() != '(' || text.back() != ')')
  {
    FailToRead(header.path, "a vector such as (1,0,0) for the " + what, Quoted(text));
  }
  return NumbersFromText(header.path, what, inside, Words(inside).size());
}

NrrdHeader ReadNrrdHeader(const std::string& path)
{
  NrrdHeader header;
  header.path = path;
  HeaderLines lines(path);
  const std::string magic = lines.Next().value_or("");
  if (magic.compare(0, 4, "NRRD") != 0)
  {
    FailToRead(path, "a first line that begins with NRRD", Quoted(magic));
  }
  // The header ends with an empty line, or with the file if the voxels are in another file.
  std::optional<std::string> line = lines.Next();
  for (; line && !line->empty(); line = lines.Next())
  {
    if (IsFileList(header.fields.Value({ "datafile" })))
    {
      header.listedFiles.push_back(Trimmed(*line));
    }
    else
    {
      TakeLine(header, *line);
    }
  }
  if (!line && !header.fields.Has("datafile"))
  {
    FailToRead(path, "an empty line after the NRRD header", "the end of the file");
  }
  header.end = lines.Position();
  return header;
}

namespace
{

std::vector<std::int64_t> SizesOf(const NrrdHeader& header)
{
  const std::int64_t rank =
    IntegerFromText(header.path, "a number of dimensions", header.fields.Value({ "dimension" }));
  if (rank < 2 || rank > 16)
  {
    FailToRead(header.path, "2 to 16 dimensions", std::to_string(rank));
  }
  std::vector<std::int64_t> sizes;
  for (const std::string& word : NrrdPartsPerAxis(header, { "sizes" }, std::size_t(rank)))
  {
    sizes.push_back(IntegerFromText(header.path, "whole numbers as sizes", word));
  }
  if (sizes.empty())
  {
    FailToRead(header.path, "the field \"sizes\"", "none");
  }
  return sizes;
}

std::string KindOf(const NrrdHeader& header, std::size_t axis)
{
  const auto kinds = NrrdParts(header.fields.Value({ "kinds" }));
  return axis < kinds.size() ? LowerCase(kinds[axis]) : "";
}

bool IsListKind(const std::string& kind)
{
  return kind == "list" || kind == "time";
}

bool IsUnknownKind(const std::string& kind)
{
  return kind.empty() || kind == "???" || kind == "none";
}

bool IsSpatialKind(const std::string& kind)
{
  return kind == "domain" || kind == "space" || IsUnknownKind(kind);
}

/// True for the direction of an axis in space: not that of a time axis in a space with time, whose
/// fourth number is the step in time.
bool IsSpatialDirection(const std::vector<double>& direction)
{
  const bool isTime = direction.size() == 4 &&
    std::all_of(direction.begin(), direction.begin() + 3, [](double x) { return x == 0.0; });
  return !direction.empty() && !isTime;
}

/// For each axis, true if the header makes it a spatial one.
std::vector<bool> SpatialAxes(const NrrdHeader& header, const std::vector<std::int64_t>& sizes)
{
  const std::size_t rank = sizes.size();
  const auto directions = NrrdPartsPerAxis(header, { "spacedirections" }, rank);
  std::vector<bool> isSpatial(rank, true);
  for (std::size_t axis = 0; axis < rank; ++axis)
  {
    isSpatial[axis] = directions.empty()
      ? IsSpatialKind(KindOf(header, axis))
      : IsSpatialDirection(NrrdVector(header, "space directions", directions[axis]));
  }
  // Without information about four axes, a short first axis holds components; otherwise the last
  // axis holds several volumes.
  if (rank == 4 && std::count(isSpatial.begin(), isSpatial.end(), true) == 4)
  {
    isSpatial[sizes[0] <= 4 ? 0 : 3] = false;
  }
  return isSpatial;
}

/// A unique spelling of a type name; NRRD has several: "unsigned short int" and "ushort" become
/// "ushort".
std::string PlainTypeName(const std::string& stated)
{
  std::string name = WithoutBlanks(LowerCase(stated));
  const auto endsWith = [&](const std::string& end)
  {
    return name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
  };
  if (endsWith("_t"))
  {
    name.erase(name.size() - 2);
  }
  if (name.compare(0, 8, "unsigned") == 0)
  {
    name.replace(0, 8, "u");
  }
  if (name.compare(0, 6, "signed") == 0 && name != "signedchar")
  {
    name.erase(0, 6);
  }
  if (endsWith("int") && name != "uint")
  {
    name.erase(name.size() - 3);
  }
  return name;
}

int TypeOf(const NrrdHeader& header)
{
  static const std::map<std::string, int> types = {
    { "signedchar", VTK_SIGNED_CHAR },
    { "int8", VTK_SIGNED_CHAR },
    { "uchar", VTK_UNSIGNED_CHAR },
    { "uint8", VTK_UNSIGNED_CHAR },
    { "short", VTK_SHORT },
    { "int16", VTK_SHORT },
    { "ushort", VTK_UNSIGNED_SHORT },
    { "uint16", VTK_UNSIGNED_SHORT },
    { "int", VTK_INT },
    { "int32", VTK_INT },
    { "uint", VTK_UNSIGNED_INT },
    { "uint32", VTK_UNSIGNED_INT },
    { "longlong", VTK_TYPE_INT64 },
    { "int64", VTK_TYPE_INT64 },
    { "ulonglong", VTK_TYPE_UINT64 },
    { "uint64", VTK_TYPE_UINT64 },
    { "float", VTK_FLOAT },
    { "double", VTK_DOUBLE },
  };
  const std::string stated = header.fields.Value({ "type" });
  const auto type = types.find(PlainTypeName(stated));
  if (type == types.end())
  {
    FailToRead(header.path, "a NRRD type such as short or float", Quoted(stated));
  }
  return type->second;
}

/// Interprets an axis before the spatial ones: components of a voxel, or several volumes whose
/// values alternate. A long axis of no known kind is several volumes.
void TakeFirstAxis(const NrrdHeader& header, std::size_t axis, NrrdAxes& axes)
{
  const std::string kind = KindOf(header, axis);
  const std::int64_t size = axes.sizes[axis];
  if (axes.componentCount > 1 || axes.volumeCount > 1)
  {
    FailToRead(header.path, "at most one axis before the spatial ones", "several");
  }
  const bool isList = IsListKind(kind) || (size > 4 && IsUnknownKind(kind));
  (isList ? axes.volumeCount : axes.componentCount) = size;
  axes.lists.insert(axes.lists.end(), isList ? 1 : 0, axis);
  axes.areAlternating = isList;
  axes.areComplex = kind == "complex";
}

/// Interprets an axis after the spatial ones: several volumes or, directly after them, components
/// that are stored one after another.
void TakeLastAxis(const NrrdHeader& header, std::size_t axis, NrrdAxes& axes)
{
  const std::string kind = KindOf(header, axis);
  axes.planar = !IsListKind(kind) && !IsSpatialKind(kind) && axes.componentCount == 1 &&
    axis == axes.spatial.back() + 1;
  if (axes.areAlternating)
  {
    FailToRead(header.path, "several volumes before or after the spatial axes", "both");
  }
  (axes.planar ? axes.componentCount : axes.volumeCount) *= axes.sizes[axis];
  axes.lists.insert(axes.lists.end(), axes.planar ? 0 : 1, axis);
}

/// Interprets an axis that is not spatial.
void TakeOtherAxis(const NrrdHeader& header, std::size_t axis, NrrdAxes& axes)
{
  if (axes.sizes[axis] < 1 || axes.sizes[axis] > std::numeric_limits<int>::max())
  {
    FailToRead(header.path, "sizes from 1 to 2147483647", std::to_string(axes.sizes[axis]));
  }
  if (axis < axes.spatial.front())
  {
    TakeFirstAxis(header, axis, axes);
  }
  else if (axis > axes.spatial.back())
  {
    TakeLastAxis(header, axis, axes);
  }
  else
  {
    FailToRead(header.path, "adjacent spatial axes", "another axis between them");
  }
}

/// The number of an axis in a field; NaN if there is none.
double NumberOfAxis(
  const NrrdHeader& header, const std::vector<std::string>& keys, const NrrdAxes& axes)
{
  const auto parts = NrrdPartsPerAxis(header, keys, axes.sizes.size());
  return parts.empty() ? NAN : NumberIn(parts[axes.lists.front()]).value_or(NAN);
}

/// The last part of a field with one for each dimension of a space with time; empty without it.
std::string TimeOfSpace(const NrrdHeader& header, const std::string& key)
{
  const auto parts = NrrdParts(header.fields.Value({ key }));
  return parts.size() == 4 ? parts[3] : "";
}

/// The times of 3D Slicer's multi-volumes, as their labels state them; empty for other files.
std::vector<double> LabelledSeconds(const NrrdHeader& header)
{
  const auto labels = header.pairs.find("MultiVolume.FrameLabels");
  const auto unit = header.pairs.find("MultiVolume.FrameIdentifyingDICOMTagUnits");
  const double seconds = unit == header.pairs.end() ? 0.0 : SecondsPerUnit(unit->second);
  std::vector<double> times;
  if (labels != header.pairs.end() && seconds > 0.0)
  {
    std::istringstream list(labels->second);
    for (std::string label; std::getline(list, label, ',');)
    {
      times.push_back(NumberIn(label).value_or(NAN) * seconds);
    }
  }
  return times;
}

}

VolumeTimes TimesOf(const NrrdHeader& header, const NrrdAxes& axes)
{
  const std::vector<double> labelled = LabelledSeconds(header);
  if (labelled.size() > 1 && std::int64_t(labelled.size()) == axes.volumeCount)
  {
    return StatedTimes(labelled);
  }
  if (axes.lists.size() != 1)
  {
    return NumberedTimes(axes.volumeCount);
  }
  const auto directions = NrrdPartsPerAxis(header, { "spacedirections" }, axes.sizes.size());
  const std::vector<double> direction = directions.empty()
    ? std::vector<double>()
    : NrrdVector(header, "space directions", directions[axes.lists.front()]);
  const auto units = NrrdParts(header.fields.Value({ "units" }));
  if (direction.size() == 4)
  {
    const std::vector<double> origin =
      NrrdVector(header, "space origin", header.fields.Value({ "spaceorigin" }));
    const double seconds = SecondsPerUnit(TimeOfSpace(header, "spaceunits"));
    return EvenTimes(
      axes.volumeCount, seconds * (origin.size() == 4 ? origin[3] : 0.0), seconds * direction[3]);
  }
  const double seconds =
    axes.lists.front() < units.size() ? SecondsPerUnit(units[axes.lists.front()]) : 0.0;
  return EvenTimes(axes.volumeCount, seconds * NumberOfAxis(header, { "axismins" }, axes),
    seconds * NumberOfAxis(header, { "spacings" }, axes));
}

NrrdAxes AxesOf(const NrrdHeader& header)
{
  NrrdAxes axes;
  axes.sizes = SizesOf(header);
  const std::vector<bool> isSpatial = SpatialAxes(header, axes.sizes);
  std::vector<std::size_t> others;
  for (std::size_t axis = 0; axis < axes.sizes.size(); ++axis)
  {
    if (isSpatial[axis])
    {
      axes.spatial.push_back(axis);
    }
    else if (axes.sizes[axis] != 1)
    {
      others.push_back(axis);
    }
  }
  if (axes.spatial.size() < 2 || axes.spatial.size() > 3)
  {
    FailToRead(header.path, "two or three spatial axes", std::to_string(axes.spatial.size()));
  }
  for (const std::size_t axis : others)
  {
    TakeOtherAxis(header, axis, axes);
  }
  return axes;
}

VoxelLayout LayoutOf(const NrrdHeader& header, const NrrdAxes& axes)
{
  VoxelLayout layout = { { 1, 1, 1 }, TypeOf(header), axes.componentCount };
  for (std::size_t i = 0; i < axes.spatial.size(); ++i)
  {
    layout.dimensions[i] = axes.sizes[axes.spatial[i]];
  }
  return layout;
}

}
