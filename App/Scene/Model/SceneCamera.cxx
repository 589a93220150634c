#include "Scene/Model/SceneCamera.h"

#include "Scene/Model/WorldVector.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace varimarch
{

namespace
{

// The automatic view is that of the largest face of a box that is much thinner along one axis than
// along the others, because such a box shows next to nothing from the side.
View ViewOf(View view, const double boundsWorld[6])
{
  if (view != View::Automatic)
  {
    return view;
  }
  constexpr double MuchThinner = 10.0;
  const double sides[] = { boundsWorld[1] - boundsWorld[0], boundsWorld[3] - boundsWorld[2],
    boundsWorld[5] - boundsWorld[4] };
  if (MuchThinner * sides[0] <= std::min(sides[1], sides[2]))
  {
    return View::Left;
  }
  return MuchThinner * sides[2] <= std::min(sides[0], sides[1]) ? View::Superior : View::Anterior;
}

struct Orientation
{
  glm::dvec3 towardsEyeWorld;
  glm::dvec3 upWorld;
};

// World space is LPS. From above and from below, the patient's front is at the top. From below, the
// patient's left is therefore on the right, as in axial slices in radiology.
Orientation OrientationOf(View view)
{
  const glm::dvec3 left(1.0, 0.0, 0.0);
  const glm::dvec3 posterior(0.0, 1.0, 0.0);
  const glm::dvec3 superior(0.0, 0.0, 1.0);
  switch (view)
  {
    case View::Posterior:
      return { posterior, superior };
    case View::Left:
      return { left, superior };
    case View::Right:
      return { -left, superior };
    case View::Superior:
      return { superior, -posterior };
    case View::Inferior:
      return { -superior, -posterior };
    default:
      return { -posterior, superior };
  }
}

// Offset of a corner of the box from its centre in view coordinates: right, up, and towards the
// eye.
glm::dvec3 CornerInView(int corner, const double boundsWorld[6], vtkMatrix4x4* viewFromWorld)
{
  double offset[4] = { 0.0, 0.0, 0.0, 0.0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double half = 0.5 * (boundsWorld[2 * axis + 1] - boundsWorld[2 * axis]);
    offset[axis] = (corner >> axis) & 1 ? half : -half;
  }
  viewFromWorld->MultiplyPoint(offset, offset);
  return { offset[0], offset[1], offset[2] };
}

void Pose(const CameraPose& pose, vtkCamera* camera)
{
  camera->SetPosition(pose.positionMm.data());
  camera->SetFocalPoint(pose.focalPointMm.data());
  camera->SetViewUp(pose.viewUp.data());
  camera->SetParallelScale(pose.parallelScaleMm);
}

}

void PlaceCamera(
  const Camera& placement, const double boundsWorld[6], double aspect, vtkCamera* camera)
{
  camera->SetParallelProjection(placement.parallel);
  camera->SetViewAngle(placement.viewAngleDegrees);
  if (placement.pose)
  {
    Pose(*placement.pose, camera);
    return;
  }
  // Turn about the centre of the box.
  const glm::dvec3 center(0.5 * (boundsWorld[0] + boundsWorld[1]),
    0.5 * (boundsWorld[2] + boundsWorld[3]), 0.5 * (boundsWorld[4] + boundsWorld[5]));
  const Orientation orientation = OrientationOf(ViewOf(placement.view, boundsWorld));
  const glm::dvec3 eye = center + orientation.towardsEyeWorld;
  camera->SetFocalPoint(center.x, center.y, center.z);
  camera->SetPosition(eye.x, eye.y, eye.z);
  camera->SetViewUp(orientation.upWorld.x, orientation.upWorld.y, orientation.upWorld.z);
  camera->Azimuth(placement.azimuthDegrees);
  camera->Elevation(placement.elevationDegrees);
  camera->OrthogonalizeViewUp();

  // Step back until every corner of the box is in the image.
  const double tangent = std::tan(0.5 * glm::radians(placement.viewAngleDegrees));
  double distance = 0.0;
  double halfHeight = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 inView = CornerInView(corner, boundsWorld, camera->GetViewTransformMatrix());
    const double needed = std::max(std::abs(inView.y), std::abs(inView.x) / aspect);
    halfHeight = std::max(halfHeight, needed);
    distance = std::max(distance, inView.z + needed / tangent);
  }
  const double* direction = camera->GetDirectionOfProjection();
  const glm::dvec3 fitted =
    center - distance * glm::dvec3(direction[0], direction[1], direction[2]);
  camera->SetPosition(fitted.x, fitted.y, fitted.z);
  camera->SetParallelScale(halfHeight);
  camera->Zoom(placement.zoom);
}

CameraPose PoseOf(vtkCamera* camera)
{
  CameraPose pose;
  camera->GetPosition(pose.positionMm.data());
  camera->GetFocalPoint(pose.focalPointMm.data());
  camera->GetViewUp(pose.viewUp.data());
  pose.parallelScaleMm = camera->GetParallelScale();
  return pose;
}

bool operator==(const CameraPose& a, const CameraPose& b)
{
  return a.positionMm == b.positionMm && a.focalPointMm == b.focalPointMm && a.viewUp == b.viewUp &&
    a.parallelScaleMm == b.parallelScaleMm;
}

Camera WithProjection(const Camera& camera, bool parallel)
{
  Camera changed = camera;
  changed.parallel = parallel;
  if (!camera.pose || camera.parallel == parallel)
  {
    return changed;
  }
  const double tangent = std::tan(0.5 * glm::radians(camera.viewAngleDegrees));
  const glm::dvec3 focalPoint = VectorOf(camera.pose->focalPointMm);
  const glm::dvec3 toEye = VectorOf(camera.pose->positionMm) - focalPoint;
  if (parallel)
  {
    changed.pose->parallelScaleMm = glm::length(toEye) * tangent;
  }
  else
  {
    const double distance = camera.pose->parallelScaleMm / tangent;
    changed.pose->positionMm = NumbersOf(focalPoint + distance * glm::normalize(toEye));
  }
  return changed;
}

std::array<double, 2> DepthRangeMm(const Camera& camera, const double boundsWorld[6], double least)
{
  vtkNew<vtkCamera> placed;
  PlaceCamera(camera, boundsWorld, 1.0, placed);
  std::array<double, 2> range = { std::numeric_limits<double>::infinity(), least };
  for (int corner = 0; corner < 8; ++corner)
  {
    double point[4] = { 0.0, 0.0, 0.0, 1.0 };
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = boundsWorld[2 * axis + ((corner >> axis) & 1)];
    }
    placed->GetViewTransformMatrix()->MultiplyPoint(point, point);
    const double depth = -point[2];
    range = { std::min(range[0], depth), std::max(range[1], depth) };
  }
  range[0] = std::max(range[0], least);
  range[1] = std::max(range[1], range[0] + least);
  return range;
}

std::array<double, 3> ViewDirection(const Camera& camera)
{
  vtkNew<vtkCamera> placed;
  const double bounds[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
  PlaceCamera(camera, bounds, 1.0, placed);
  std::array<double, 3> direction;
  placed->GetDirectionOfProjection(direction.data());
  return direction;
}

}
