#include "Scene/SceneCuts.h"

#include "Scene/WorldVector.h"

#include <vtkImageData.h>
#include <vtkMatrix3x3.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace varimarch
{

namespace
{

// Normal of a face: perpendicular to the two other axes. In a sheared volume it differs from the
// axis.
glm::dvec3 NormalOf(int axis, vtkImageData* image)
{
  const auto direction = [&](int of)
  {
    const double* const elements = image->GetDirectionMatrix()->GetData();
    return glm::dvec3(elements[of], elements[3 + of], elements[6 + of]);
  };
  const glm::dvec3 normal = glm::cross(direction((axis + 1) % 3), direction((axis + 2) % 3));
  return glm::dot(normal, direction(axis)) > 0.0 ? normal : -normal;
}

}

glm::dvec3 PointAtParts(const glm::dvec3& parts, vtkImageData* image)
{
  const int* const extent = image->GetExtent();
  double index[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double first = extent[2 * axis];
    index[axis] = first + parts[axis] * (extent[2 * axis + 1] - first);
  }
  glm::dvec3 pointWorld;
  image->TransformContinuousIndexToPhysicalPoint(index, &pointWorld.x);
  return pointWorld;
}

std::vector<CutPlane> PlanesOf(const SceneCuts& cuts, vtkImageData* image)
{
  std::vector<CutPlane> planes;
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3 normal = NormalOf(axis, image);
    glm::dvec3 parts(0.5);
    if (parts[axis] = cuts.box[2 * axis]; parts[axis] > 0.0)
    {
      planes.push_back({ NumbersOf(PointAtParts(parts, image)), NumbersOf(normal) });
    }
    if (parts[axis] = cuts.box[2 * axis + 1]; parts[axis] < 1.0)
    {
      planes.push_back({ NumbersOf(PointAtParts(parts, image)), NumbersOf(-normal) });
    }
  }
  planes.insert(planes.end(), cuts.planes.begin(), cuts.planes.end());
  return planes;
}

bool IsKept(const glm::dvec3& pointMm, const std::vector<CutPlane>& planes)
{
  return std::all_of(planes.begin(), planes.end(),
    [&](const CutPlane& plane)
    { return glm::dot(VectorOf(plane.normal), pointMm - VectorOf(plane.pointMm)) >= 0.0; });
}

std::array<double, 3> MiddleOf(vtkImageData* image)
{
  return NumbersOf(PointAtParts(glm::dvec3(0.5), image));
}

void MoveFace(std::array<double, 6>& box, int face, double part)
{
  constexpr double Thinnest = 0.001;
  box[face] = face % 2 == 0 ? std::clamp(part, 0.0, box[face + 1] - Thinnest)
                            : std::clamp(part, box[face - 1] + Thinnest, 1.0);
}

std::array<double, 6> BoxInOther(
  const std::array<double, 6>& box, vtkImageData* image, vtkImageData* other)
{
  const std::array<double, 6> whole = SceneCuts().box;
  std::array<double, 6> moved = whole;
  for (int face = 0; face < 6; ++face)
  {
    const int axis = face / 2;
    glm::dvec3 parts(0.5);
    parts[axis] = box[face];
    const glm::dvec3 pointWorld = PointAtParts(parts, image);
    double index[3];
    other->TransformPhysicalPointToContinuousIndex(&pointWorld.x, index);
    const int* const extent = other->GetExtent() + 2 * axis;
    const double steps = std::max(1, extent[1] - extent[0]);
    if (box[face] != whole[face])
    {
      MoveFace(moved, face, (index[axis] - extent[0]) / steps);
    }
  }
  return moved;
}

std::array<double, 2> ReachAlong(const std::array<double, 3>& normal, vtkImageData* image)
{
  const glm::dvec3 direction = glm::normalize(VectorOf(normal));
  const glm::dvec3 middle = PointAtParts(glm::dvec3(0.5), image);
  std::array<double, 2> reach = { std::numeric_limits<double>::max(),
    std::numeric_limits<double>::lowest() };
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 parts(corner & 1, corner >> 1 & 1, corner >> 2);
    const double distanceMm = glm::dot(direction, PointAtParts(parts, image) - middle);
    reach = { std::min(reach[0], distanceMm), std::max(reach[1], distanceMm) };
  }
  return reach;
}

double DepthOf(const CutPlane& plane, vtkImageData* image)
{
  const auto [first, last] = ReachAlong(plane.normal, image);
  const glm::dvec3 fromMiddle = VectorOf(plane.pointMm) - VectorOf(MiddleOf(image));
  const double distanceMm = glm::dot(glm::normalize(VectorOf(plane.normal)), fromMiddle);
  return std::clamp((distanceMm - first) / (last - first), 0.0, 1.0);
}

CutPlane AtDepth(double depth, const CutPlane& plane, vtkImageData* image)
{
  const auto [first, last] = ReachAlong(plane.normal, image);
  const glm::dvec3 alongMm =
    (first + depth * (last - first)) * glm::normalize(VectorOf(plane.normal));
  return { NumbersOf(VectorOf(MiddleOf(image)) + alongMm), plane.normal };
}

}
