#include "Frame/DrawnPart.h"

#include "Frame/Cuts.h"
#include "Frame/MapperInput.h"
#include "Frame/NumberCheck.h"

#include "vtkCamera.h"
#include "vtkMultiVolume.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <optional>

namespace varimarch
{

namespace
{

// Half-spaces that keep dot(plane, (position, 1)) >= 0.
using Planes = std::vector<glm::dvec4>;

// Lengths below this part of a size count as rounding.
constexpr double SmallPart = 1e-6;

// The box of the input if that is known, else the bounds as an image of two voxels along each axis.
VolumeGeometry GeometryOf(vtkVolume* volume, vtkVolumeMapper* mapper)
{
  const double* const bounds = volume->GetBounds(); // updates the input, too
  VolumeGeometry geometry = {};
  geometry.dataFromGrid = glm::dmat4(1.0);
  geometry.worldFromGrid = glm::dmat4(1.0);
  geometry.boxGrid = { { bounds[0], bounds[2], bounds[4] }, { bounds[1], bounds[3], bounds[5] } };
  if (vtkMultiVolume::SafeDownCast(volume))
  {
    return geometry;
  }
  try
  {
    const std::optional<MapperInput> input = InputOf(mapper);
    return input ? input->Geometry(volume, input->Axes(false)) : geometry;
  }
  catch (const std::exception&)
  {
    return geometry; // the fault is reported when the volume is drawn
  }
}

// Planes around the regions of cropping that are drawn.
void AppendRegions(const CroppingRegions& regions, Planes& planes)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    constexpr int Strides[3] = { 1, 3, 9 };
    bool isDrawn[3] = { false, false, false };
    for (int region = 0; region < 27; ++region)
    {
      const bool isRegionDrawn = (regions.drawn >> region & 1) != 0;
      isDrawn[region / Strides[axis] % 3] |= isRegionDrawn;
    }
    const glm::dvec4& lower = regions.planesGrid[2 * axis];
    const glm::dvec4& upper = regions.planesGrid[2 * axis + 1];
    if (!isDrawn[0])
    {
      planes.push_back(isDrawn[1] ? lower : upper);
    }
    if (!isDrawn[2])
    {
      planes.push_back(isDrawn[1] ? -upper : -lower);
    }
  }
}

Planes PlanesOf(const Cuts& cuts)
{
  Planes planes = cuts.planesGrid;
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec4 plane(0.0);
    plane[axis] = 1.0;
    plane.w = -cuts.boxGrid.lower[axis];
    planes.push_back(plane);
    plane.w = -cuts.boxGrid.upper[axis];
    planes.push_back(-plane);
  }
  if (cuts.regions)
  {
    AppendRegions(*cuts.regions, planes);
  }
  return planes;
}

// The point in three planes, if they have one.
std::optional<glm::dvec3> CommonPoint(
  const glm::dvec4& one, const glm::dvec4& two, const glm::dvec4& three)
{
  const glm::dmat3 normals =
    glm::transpose(glm::dmat3(glm::dvec3(one), glm::dvec3(two), glm::dvec3(three)));
  constexpr double Parallel = 1e-9;
  return std::abs(glm::determinant(normals)) > Parallel
    ? std::optional(-(glm::inverse(normals) * glm::dvec3(one.w, two.w, three.w)))
    : std::nullopt;
}

// The corners of the convex body that planes bound: the points in three of them that no plane cuts
// off.
std::vector<glm::dvec3> CornersOf(const Planes& planes, double size)
{
  std::vector<glm::dvec3> corners;
  for (std::size_t i = 0; i < planes.size(); ++i)
  {
    for (std::size_t j = i + 1; j < planes.size(); ++j)
    {
      for (std::size_t k = j + 1; k < planes.size(); ++k)
      {
        const std::optional<glm::dvec3> point = CommonPoint(planes[i], planes[j], planes[k]);
        if (point &&
          std::all_of(planes.begin(), planes.end(),
            [&](const glm::dvec4& plane)
            { return glm::dot(plane, glm::dvec4(*point, 1.0)) >= -SmallPart * size; }))
        {
          corners.push_back(*point);
        }
      }
    }
  }
  return corners;
}

Box BoxAround(const std::vector<glm::dvec3>& points)
{
  Box box{ points.front(), points.front() };
  for (const glm::dvec3& point : points)
  {
    box.lower = glm::min(box.lower, point);
    box.upper = glm::max(box.upper, point);
  }
  return box;
}

struct Extent
{
  double lower = std::numeric_limits<double>::infinity();
  double upper = -std::numeric_limits<double>::infinity();
};

Extent ExtentOf(const DrawnPart& part, const glm::dvec3& direction)
{
  Extent extent;
  for (const glm::dvec3& corner : part.corners)
  {
    extent.lower = std::min(extent.lower, glm::dot(corner, direction));
    extent.upper = std::max(extent.upper, glm::dot(corner, direction));
  }
  return extent;
}

// How far the camera is on the upper side of a place along a direction; only the sign counts.
double HeightOfCamera(vtkCamera* camera, const glm::dvec3& direction, double place)
{
  return camera->GetParallelProjection()
    ? -glm::dot(direction, glm::make_vec3(camera->GetDirectionOfProjection()))
    : glm::dot(direction, glm::make_vec3(camera->GetPosition())) - place;
}

// Directions across which a plane between two parts may lie: the normals of their faces, and those
// of an edge of each, which are parallel to normals in boxes.
std::vector<glm::dvec3> DirectionsOf(const DrawnPart& first, const DrawnPart& second)
{
  std::vector<glm::dvec3> directions = first.normals;
  directions.insert(directions.end(), second.normals.begin(), second.normals.end());
  for (const glm::dvec3& one : first.normals)
  {
    for (const glm::dvec3& other : second.normals)
    {
      const glm::dvec3 across = glm::cross(one, other);
      const double length = glm::length(across);
      if (length > SmallPart)
      {
        directions.push_back(across / length);
      }
    }
  }
  return directions;
}

}

glm::dvec3 DrawnPart::Center() const
{
  if (this->corners.empty())
  {
    return glm::dvec3(0.0);
  }
  const Box box = BoxAround(this->corners);
  return 0.5 * (box.lower + box.upper);
}

double DrawnPart::Length() const
{
  if (this->corners.empty())
  {
    return 0.0;
  }
  const Box box = BoxAround(this->corners);
  return glm::length(box.upper - box.lower);
}

DrawnPart DrawnPartOf(vtkVolume* volume)
{
  if (!volume->GetBounds())
  {
    return {}; // its bounds are not finite, so that it is not drawn
  }
  auto* const mapper = vtkVolumeMapper::SafeDownCast(volume->GetMapper());
  const VolumeGeometry geometry = GeometryOf(volume, mapper);
  NumberCheck check; // its sentences are told when the volume is drawn
  const Planes planes = PlanesOf(CutsOf(mapper, geometry, false, check));
  const glm::dmat4 planesFromGrid = glm::inverse(geometry.worldFromGrid);
  const double sizeGrid = glm::length(geometry.boxGrid.upper - geometry.boxGrid.lower);
  DrawnPart part;
  for (const glm::dvec3& corner : CornersOf(planes, sizeGrid))
  {
    part.corners.emplace_back(geometry.worldFromGrid * glm::dvec4(corner, 1.0));
  }
  for (const glm::dvec4& plane : planes)
  {
    const glm::dvec3 normal(plane * planesFromGrid);
    const double length = glm::length(normal);
    if (length > 0.0)
    {
      part.normals.push_back(normal / length);
    }
  }
  return part;
}

Sides SidesOf(const DrawnPart& first, const DrawnPart& second, vtkCamera* camera)
{
  if (first.corners.empty() || second.corners.empty())
  {
    return Sides::Unknown;
  }
  const double rounding = 2.0 * SmallPart * (first.Length() + second.Length());
  for (const glm::dvec3& direction : DirectionsOf(first, second))
  {
    const Extent one = ExtentOf(first, direction);
    const Extent other = ExtentOf(second, direction);
    const bool firstIsUpper = other.upper <= one.lower + rounding;
    const bool firstIsLower = one.upper <= other.lower + rounding;
    const double place = firstIsUpper ? one.lower : other.lower;
    const double height = HeightOfCamera(camera, direction, place);
    if (firstIsUpper != firstIsLower && height != 0.0)
    {
      return (height > 0.0) == firstIsUpper ? Sides::FirstInFront : Sides::SecondInFront;
    }
  }
  return Sides::Unknown;
}

}
