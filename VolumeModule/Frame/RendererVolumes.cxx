#include "Frame/RendererVolumes.h"

#include "Frame/Cuts.h"
#include "Frame/MapperInput.h"
#include "Frame/NumberCheck.h"
#include "vtkVariationFieldGPUVolumeRayCastMapper.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "vtkCamera.h"
#include "vtkMultiVolume.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace varimarch
{

namespace
{

/// The part of a volume's box that clipping planes and cropping leave, in world space. It is
/// convex: regions of cropping count as the box around them. It decides which of two volumes is in
/// front, so it need not be exact to more than a millionth of its size.
struct DrawnPart
{
  std::vector<glm::dvec3> corners; ///< Empty if nothing is left.
  std::vector<glm::dvec3> normals; ///< The normals of its faces, of length 1.

  glm::dvec3 Center() const; ///< That of the box around the corners along the world's axes.
  double Length() const;     ///< The length of the diagonal of that box [mm].
};

/// The sides of a plane on which two parts are, seen from a camera.
enum class Sides
{
  FirstInFront,
  SecondInFront,
  Unknown, ///< No plane separates the parts, or the camera looks along it.
};

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

/// The drawn part of a volume whose mapper is a vtkVolumeMapper with an input; of a vtkMultiVolume,
/// its bounds. It has no corners if the volume has no finite bounds.
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

/// Looks for a plane between two parts. The part on the camera's side of it covers the other.
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

// A volume and the order of drawing that its place suggests: smaller is drawn earlier.
struct Placed
{
  vtkVolume* volume;
  DrawnPart part;
  float nearness;  ///< minus the distance from the camera; centres may differ by rounding
  double openness; ///< minus the size: what surrounds another comes first

  bool operator<(const Placed& other) const
  {
    return std::tie(this->nearness, this->openness) < std::tie(other.nearness, other.openness);
  }
};

// The distance of a place from the camera; in a parallel projection, along the view.
double DistanceOf(const glm::dvec3& place, vtkCamera* camera)
{
  const glm::dvec3 fromCamera = place - glm::make_vec3(camera->GetPosition());
  return camera->GetParallelProjection()
    ? glm::dot(fromCamera, glm::make_vec3(camera->GetDirectionOfProjection()))
    : glm::length(fromCamera);
}

Placed PlacedIn(vtkVolume* volume, vtkCamera* camera)
{
  DrawnPart part = DrawnPartOf(volume);
  const double distance = DistanceOf(part.Center(), camera);
  const double length = part.Length();
  return { volume, std::move(part), -float(distance), -length };
}

// True if no other volume is known to be behind one.
bool IsFarthest(const Placed& one, const std::vector<Placed>& all, vtkCamera* camera)
{
  return std::none_of(all.begin(), all.end(),
    [&](const Placed& other)
    { return SidesOf(one.part, other.part, camera) == Sides::FirstInFront; });
}

}

vtkVariationFieldVolumeMapper* DrawingMapper(vtkVolume* volume)
{
  vtkAbstractVolumeMapper* const mapper = volume->GetMapper();
  auto* const adapter = vtkVariationFieldGPUVolumeRayCastMapper::SafeDownCast(mapper);
  return adapter ? adapter->GetVariationFieldMapper()
                 : vtkVariationFieldVolumeMapper::SafeDownCast(mapper);
}

bool IsLeftToVtk(vtkVolume* volume, vtkRenderer* renderer)
{
  auto* const adapter = vtkVariationFieldGPUVolumeRayCastMapper::SafeDownCast(volume->GetMapper());
  return adapter && !adapter->ChooseMapper(renderer, volume);
}

std::vector<vtkVolume*> VolumesBackToFront(vtkRenderer* renderer)
{
  vtkCamera* const camera = renderer->GetActiveCamera();
  std::vector<Placed> left;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    auto* volume = vtkVolume::SafeDownCast(prop);
    if (volume && DrawingMapper(volume) && volume->GetVisibility() &&
      volume->GetMapper()->GetDataObjectInput())
    {
      left.push_back(PlacedIn(volume, camera));
    }
  }
  std::stable_sort(left.begin(), left.end());

  // The first that covers no other is drawn next; where all cover each other in a ring, the first.
  std::vector<vtkVolume*> volumes;
  while (!left.empty())
  {
    const auto farthest = std::find_if(
      left.begin(), left.end(), [&](const Placed& one) { return IsFarthest(one, left, camera); });
    const auto next = farthest == left.end() ? left.begin() : farthest;
    volumes.push_back(next->volume);
    left.erase(next);
  }
  return volumes;
}

vtkMTimeType TimeOf(const std::vector<vtkVolume*>& volumes, vtkRenderer* renderer)
{
  vtkMTimeType time = std::max(renderer->GetMTime(), renderer->GetActiveCamera()->GetMTime());
  for (vtkVolume* volume : volumes)
  {
    time = std::max(time, volume->GetMTime());
  }
  return time;
}

}
