#ifndef Varimarch_Viewer_PictureFrame_h
#define Varimarch_Viewer_PictureFrame_h

#include <glm/vec3.hpp>

#include <QPointF>
#include <QSizeF>

#include <array>
#include <functional>
#include <optional>

class vtkCamera;

namespace varimarch
{

/// The line of sight through a position of an image, in world space [mm].
struct SightLine
{
  glm::dvec3 nearest; ///< end next to the eye
  glm::dvec3 farthest;
};

/// Maps between the world and the image of a view. Positions are measured from the upper left
/// corner [logical pixels].
struct PictureFrame
{
  QSizeF size;
  /// Projects a point in world space [mm]; empty for points behind the eye.
  std::function<std::optional<QPointF>(const std::array<double, 3>&)> pixelOf;
  std::function<SightLine(const QPointF&)> sightLineAt;
  std::array<double, 3> rightWorld; ///< unit vectors of the view: right, up and towards the eye
  std::array<double, 3> upWorld;
  std::array<double, 3> towardsEyeWorld;

  /// Scale at a point in world space [mm]; 0 for points behind the eye.
  double PixelsPerMm(const std::array<double, 3>& point) const;
};

PictureFrame FrameOf(vtkCamera* camera, const QSizeF& size);

/// Position along a line of its point nearest to a line of sight, measured from `point` [mm]. Empty
/// if the lines are nearly parallel.
/// @param direction  unit vector
std::optional<double> NearestAlong(
  const glm::dvec3& point, const glm::dvec3& direction, const SightLine& sight);

/// Direction from the centre of a sphere to its intersection with a line of sight, on the
/// hemisphere of `side`. A line that misses the sphere gives the direction to the silhouette.
glm::dvec3 DirectionOnSphere(
  const glm::dvec3& middle, double radiusMm, const glm::dvec3& side, const SightLine& sight);

}

#endif
