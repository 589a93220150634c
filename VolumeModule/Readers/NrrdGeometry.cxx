#include "Readers/NrrdGeometry.h"

#include "Readers/FileError.h"
#include "Readers/NumberText.h"
#include "Readers/VolumeFile.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

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

}

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

}
