#ifndef Varimarch_Viewer_Overlay_h
#define Varimarch_Viewer_Overlay_h

#include "Scene/Scene.h"

#include <QPointF>
#include <QSizeF>
#include <QString>

#include <array>
#include <functional>
#include <optional>

class QPainter;
class vtkCamera;

namespace varimarch
{

/// How a view maps the world to its picture.
struct PictureFrame
{
  QSizeF size; ///< [logical pixels]
  /// Of a point in world space [mm]; from the upper left corner; none behind the eye.
  std::function<std::optional<QPointF>(const std::array<double, 3>&)> pixelOf;
  std::array<double, 3> rightWorld; ///< of the picture
  std::array<double, 3> upWorld;
  std::array<double, 3> towardsEyeWorld;
};

PictureFrame FrameOf(vtkCamera* camera, const QSizeF& size);

/// What is written over a picture of a scene, on the screen and in files alike: the letters of the
/// patient's directions at its edges, a cube with the same letters, and the distances measured.
void DrawOverlay(QPainter& painter, const Scene& scene, const PictureFrame& frame);

/// A distance as people read it: "12.3 mm".
QString DistanceText(const Distance& distance);

}

#endif
