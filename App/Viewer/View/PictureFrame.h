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

/// What lies below a place of a picture, in world space [mm].
struct SightLine
{
  glm::dvec3 nearest; ///< to the eye
  glm::dvec3 farthest;
};

/// How a view maps the world to its picture. Places are from the upper left corner [logical
/// pixels].
struct PictureFrame
{
  QSizeF size;
  /// Of a point in world space [mm]; none behind the eye.
  std::function<std::optional<QPointF>(const std::array<double, 3>&)> pixelOf;
  std::function<SightLine(const QPointF&)> sightLineAt;
  std::array<double, 3> rightWorld; ///< of the picture
  std::array<double, 3> upWorld;
  std::array<double, 3> towardsEyeWorld;

  /// At a point in world space [mm]; of a point behind the eye 0.
  double PixelsPerMm(const std::array<double, 3>& point) const;
};

PictureFrame FrameOf(vtkCamera* camera, const QSizeF& size);

/// How far along a line the point lies that is nearest to a sight line, from its first point [mm];
/// none where both are nearly parallel.
/// @param direction  of length 1
std::optional<double> NearestAlong(
  const glm::dvec3& point, const glm::dvec3& direction, const SightLine& sight);

/// The direction from the middle of a sphere to where a sight line meets it, on the side of another
/// direction; beside the sphere to its edge.
glm::dvec3 DirectionOnSphere(
  const glm::dvec3& middle, double radiusMm, const glm::dvec3& side, const SightLine& sight);

}

#endif
