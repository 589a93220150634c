#include "Viewer/Tools/CutDragging.h"

#include "Scene/SceneCuts.h"
#include "Scene/WorldVector.h"

#include <vtkBoundingBox.h>
#include <vtkImageData.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace varimarch
{

namespace
{

constexpr double ArrowPixels = 70.0;

glm::dvec3 AwayFrom(const CutPlane& plane)
{
  return -glm::normalize(VectorOf(plane.normal));
}

double ArrowMm(const glm::dvec3& foot, const PictureFrame& frame)
{
  return ArrowPixels / std::max(frame.PixelsPerMm(NumbersOf(foot)), 1e-6);
}

glm::dvec3 MiddlePartsOf(const std::array<double, 6>& box)
{
  return 0.5 * glm::dvec3(box[0] + box[1], box[2] + box[3], box[4] + box[5]);
}

// Distance that the mouse drags a point along a line [mm]. If the line points towards the eye,
// dragging upwards pushes away from it.
double MovedAlong(const glm::dvec3& point, const glm::dvec3& direction, const MouseDrag& drag)
{
  const auto from = NearestAlong(point, direction, drag.frame.sightLineAt(drag.from));
  const auto to = NearestAlong(point, direction, drag.frame.sightLineAt(drag.to));
  if (from && to)
  {
    return *to - *from;
  }
  const double upwardsMm =
    (drag.from.y() - drag.to.y()) / std::max(drag.frame.PixelsPerMm(NumbersOf(point)), 1e-6);
  return glm::dot(direction, VectorOf(drag.frame.towardsEyeWorld)) < 0.0 ? upwardsMm : -upwardsMm;
}

CutPlane Pushed(
  const CutPlane& plane, const glm::dvec3& foot, const MouseDrag& drag, vtkImageData* image)
{
  const glm::dvec3 normal = glm::normalize(VectorOf(plane.normal));
  const auto [first, last] = ReachAlong(plane.normal, image);
  const double now = glm::dot(normal, foot - VectorOf(MiddleOf(image)));
  const double moved = std::clamp(MovedAlong(foot, normal, drag), first - now, last - now);
  return { NumbersOf(foot + moved * normal), plane.normal };
}

CutPlane Turned(
  const CutPlane& plane, const glm::dvec3& tip, const MouseDrag& drag, vtkImageData* image)
{
  const glm::dvec3 foot = PlaneFoot(plane, image);
  const glm::dvec3 away = DirectionOnSphere(
    foot, glm::distance(foot, tip), AwayFrom(plane), drag.frame.sightLineAt(drag.to));
  return { NumbersOf(foot), NumbersOf(-away) };
}

// Fraction of the volume that the mouse drags a point along one of its axes.
double MovedPart(const glm::dvec3& point, int axis, const MouseDrag& drag, vtkImageData* image)
{
  glm::dvec3 last(0.0);
  last[axis] = 1.0;
  const glm::dvec3 along = PointAtParts(last, image) - PointAtParts(glm::dvec3(0.0), image);
  const double lengthMm = glm::length(along);
  return lengthMm > 0.0 ? MovedAlong(point, along / lengthMm, drag) / lengthMm : 0.0;
}

void MoveBox(
  std::array<double, 6>& box, const glm::dvec3& middle, const MouseDrag& drag, vtkImageData* image)
{
  const double mmPerPixel = 1.0 / std::max(drag.frame.PixelsPerMm(NumbersOf(middle)), 1e-6);
  const QPointF moved = mmPerPixel * (drag.to - drag.from);
  const glm::dvec3 movedMm =
    moved.x() * VectorOf(drag.frame.rightWorld) - moved.y() * VectorOf(drag.frame.upWorld);
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3 last(0.0);
    last[axis] = 1.0;
    const glm::dvec3 along = PointAtParts(last, image) - PointAtParts(glm::dvec3(0.0), image);
    const double squaredMm = std::max(glm::dot(along, along), 1e-12);
    const double part =
      std::clamp(glm::dot(movedMm, along) / squaredMm, -box[2 * axis], 1.0 - box[2 * axis + 1]);
    box[2 * axis] += part;
    box[2 * axis + 1] += part;
  }
}

}

glm::dvec3 PlaneFoot(const CutPlane& plane, vtkImageData* image)
{
  const bool inside = vtkBoundingBox(image->GetBounds()).ContainsPoint(plane.pointMm.data());
  return VectorOf(inside ? plane.pointMm : AtDepth(DepthOf(plane, image), plane, image).pointMm);
}

std::vector<CutHandle> HandlesOf(
  const SceneCuts& cuts, vtkImageData* image, const PictureFrame& frame)
{
  std::vector<CutHandle> handles;
  for (int i = 0; i < int(cuts.planes.size()); ++i)
  {
    const glm::dvec3 foot = PlaneFoot(cuts.planes[i], image);
    const glm::dvec3 tip = foot + ArrowMm(foot, frame) * AwayFrom(cuts.planes[i]);
    handles.push_back({ CutHandleKind::PushPlane, i, NumbersOf(foot) });
    handles.push_back({ CutHandleKind::TurnPlane, i, NumbersOf(tip) });
  }
  // The box comes before its faces: seen from the front, the centre hides two of their handles.
  const glm::dvec3 middle = MiddlePartsOf(cuts.box);
  if (cuts.box != SceneCuts().box)
  {
    handles.push_back({ CutHandleKind::MoveBox, 0, NumbersOf(PointAtParts(middle, image)) });
  }
  for (int face = 0; face < 6; ++face)
  {
    glm::dvec3 parts = middle;
    parts[face / 2] = cuts.box[face];
    handles.push_back({ CutHandleKind::MoveFace, face, NumbersOf(PointAtParts(parts, image)) });
  }
  return handles;
}

SceneCuts Dragged(
  const SceneCuts& cuts, const CutHandle& handle, const MouseDrag& drag, vtkImageData* image)
{
  SceneCuts dragged = cuts;
  const glm::dvec3 point = VectorOf(handle.pointMm);
  switch (handle.kind)
  {
    case CutHandleKind::PushPlane:
      dragged.planes[handle.index] = Pushed(cuts.planes[handle.index], point, drag, image);
      break;
    case CutHandleKind::TurnPlane:
      dragged.planes[handle.index] = Turned(cuts.planes[handle.index], point, drag, image);
      break;
    case CutHandleKind::MoveFace:
      MoveFace(dragged.box, handle.index,
        cuts.box[handle.index] + MovedPart(point, handle.index / 2, drag, image));
      break;
    case CutHandleKind::MoveBox:
      MoveBox(dragged.box, point, drag, image);
      break;
  }
  return dragged;
}

}
