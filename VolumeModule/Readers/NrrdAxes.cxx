#include "Readers/NrrdAxes.h"

#include "Readers/FileError.h"
#include "Readers/NumberText.h"
#include "Readers/VolumeFile.h"

#include <algorithm>
#include <map>

namespace varimarch
{
namespace
{

/// Parses a vector "(x,y,z)".
glm::dvec3 VectorFromText(const std::string& path, const std::string& what, std::string text)
{
  std::string inside = text;
  std::replace_if(
    inside.begin(), inside.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
  if (text.empty() || text.front() != '(' || text.back() != ')')
  {
    FailToRead(path, "a vector such as (1,0,0) for the " + what, Quoted(text));
  }
  const std::vector<double> numbers = NumbersFromText(path, what, inside, 3);
  return { numbers[0], numbers[1], numbers[2] };
}

/// The parts of a field with one part per axis; empty if the field is missing.
std::vector<std::string> PartsPerAxis(
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

std::vector<std::int64_t> SizesOf(const NrrdHeader& header)
{
  const std::int64_t rank =
    IntegerFromText(header.path, "a number of dimensions", header.fields.Value({ "dimension" }));
  if (rank < 2 || rank > 16)
  {
    FailToRead(header.path, "2 to 16 dimensions", std::to_string(rank));
  }
  std::vector<std::int64_t> sizes;
  for (const std::string& word : PartsPerAxis(header, { "sizes" }, std::size_t(rank)))
  {
    sizes.push_back(IntegerFromText(header.path, "whole numbers as sizes", word));
  }
  if (sizes.empty())
  {
    FailToRead(header.path, "the field \"sizes\"", "none");
  }
  return sizes;
}

/// For each axis, true if the header makes it a spatial one.
std::vector<bool> SpatialAxes(const NrrdHeader& header, const std::vector<std::int64_t>& sizes)
{
  const std::size_t rank = sizes.size();
  const auto directions = PartsPerAxis(header, { "spacedirections" }, rank);
  const auto kinds = PartsPerAxis(header, { "kinds" }, rank);
  std::vector<bool> isSpatial(rank, true);
  for (std::size_t axis = 0; axis < rank; ++axis)
  {
    if (!directions.empty())
    {
      isSpatial[axis] = directions[axis].front() == '(';
    }
    else if (!kinds.empty())
    {
      const std::string kind = LowerCase(kinds[axis]);
      isSpatial[axis] = kind == "domain" || kind == "space" || kind == "???" || kind == "none";
    }
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

bool IsVectorKind(const NrrdHeader& header, std::size_t axis)
{
  const auto kinds = NrrdParts(header.fields.Value({ "kinds" }));
  const std::string kind = axis < kinds.size() ? LowerCase(kinds[axis]) : "";
  return kind.find("vector") != std::string::npos || kind.find("color") != std::string::npos;
}

/// Interprets an axis that is not spatial: components of a voxel, or several volumes.
void TakeOtherAxis(
  const NrrdHeader& header, std::size_t other, NrrdAxes& axes, std::vector<std::string>& warnings)
{
  const std::int64_t size = axes.sizes[other];
  if (size < 1)
  {
    FailToRead(header.path, "sizes above 0", std::to_string(size));
  }
  if (other > axes.spatial.front() && other < axes.spatial.back())
  {
    FailToRead(header.path, "adjacent spatial axes", "another axis between them");
  }
  axes.planar = other > axes.spatial.back() && IsVectorKind(header, other);
  if (other < axes.spatial.front() || axes.planar)
  {
    axes.componentCount = size;
  }
  else
  {
    axes.volumeCount = size;
    warnings.push_back(OnlyFirstVolume(size));
  }
}

/// Sign changes that convert the axes of a named space to LPS.
enum class SpaceTurn
{
  None,
  LeftRight,
  FrontBack,
  Both,
  Unknown
};

SpaceTurn TurnOfSpace(const NrrdHeader& header)
{
  static const std::map<std::string, SpaceTurn> turns = {
    { "left-posterior-superior", SpaceTurn::None },
    { "lps", SpaceTurn::None },
    { "right-posterior-superior", SpaceTurn::LeftRight },
    { "rps", SpaceTurn::LeftRight },
    { "left-anterior-superior", SpaceTurn::FrontBack },
    { "las", SpaceTurn::FrontBack },
    { "right-anterior-superior", SpaceTurn::Both },
    { "ras", SpaceTurn::Both },
    { "", SpaceTurn::Unknown },
    { "scanner-xyz", SpaceTurn::Unknown },
    { "3d-right-handed", SpaceTurn::Unknown },
    { "3d-left-handed", SpaceTurn::Unknown },
  };
  const std::string space = header.fields.Value({ "space" });
  const auto turn = turns.find(LowerCase(space));
  if (turn == turns.end())
  {
    FailToRead(
      header.path, "a three-dimensional space such as left-posterior-superior", Quoted(space));
  }
  return turn->second;
}

/// Length of the space's unit [mm].
double MmPerSpaceUnit(const NrrdHeader& header)
{
  for (std::string unit : NrrdParts(header.fields.Value({ "spaceunits", "units" })))
  {
    unit.erase(std::remove(unit.begin(), unit.end(), '"'), unit.end());
    if (MmPerUnit(unit) != 1.0)
    {
      return MmPerUnit(unit);
    }
  }
  return 1.0;
}

}

NrrdAxes AxesOf(const NrrdHeader& header, std::vector<std::string>& warnings)
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
  if (axes.spatial.size() < 2 || axes.spatial.size() > 3 || others.size() > 1)
  {
    FailToRead(header.path, "three spatial axes and at most one other",
      std::to_string(axes.spatial.size()) + " and " + std::to_string(others.size()));
  }
  if (!others.empty())
  {
    TakeOtherAxis(header, others.front(), axes, warnings);
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

ImageGeometry GeometryOf(
  const NrrdHeader& header, const NrrdAxes& axes, std::vector<std::string>& warnings)
{
  const std::size_t rank = axes.sizes.size();
  const auto directions = PartsPerAxis(header, { "spacedirections" }, rank);
  const auto spacings = PartsPerAxis(header, { "spacings" }, rank);
  ImageGeometry geometry;
  for (std::size_t i = 0; i < axes.spatial.size(); ++i)
  {
    const std::size_t axis = axes.spatial[i];
    if (!directions.empty())
    {
      geometry.axesMm[int(i)] = VectorFromText(header.path, "space directions", directions[axis]);
    }
    else if (!spacings.empty())
    {
      geometry.axesMm[int(i)] *= NumberFromText(header.path, "numbers as spacings", spacings[axis]);
    }
  }
  const std::string origin = header.fields.Value({ "spaceorigin" });
  if (!origin.empty())
  {
    geometry.originMm = VectorFromText(header.path, "space origin", origin);
  }

  const SpaceTurn turn = TurnOfSpace(header);
  const bool turnsX = turn == SpaceTurn::LeftRight || turn == SpaceTurn::Both;
  const bool turnsY = turn == SpaceTurn::FrontBack || turn == SpaceTurn::Both;
  if (turn == SpaceTurn::Unknown)
  {
    warnings.push_back(UnknownSides);
  }
  return InLps(geometry, { turnsX ? -1.0 : 1.0, turnsY ? -1.0 : 1.0, 1.0 }, MmPerSpaceUnit(header));
}

}
