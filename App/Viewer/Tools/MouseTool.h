#ifndef Varimarch_Viewer_MouseTool_h
#define Varimarch_Viewer_MouseTool_h

#include "Viewer/View/PictureFrame.h"

#include <QPointF>

#include <array>
#include <optional>

class QPainter;

namespace varimarch
{

/// A view as far as its tools know it.
class ToolSurface
{
public:
  virtual ~ToolSurface() = default;

  virtual PictureFrame Frame() const = 0;

  /// What is seen at a place, in world space [mm]; none where nothing is.
  virtual std::optional<std::array<double, 3>> PointAt(const QPointF& place) const = 0;

  /// Of a slice the direction across it, of length 1; of a view into the depth none.
  virtual std::optional<glm::dvec3> Through() const { return std::nullopt; }

  /// Whether it shows what lies between two corners [mm].
  virtual bool Shows(const std::array<double, 3>&, const std::array<double, 3>&) const
  {
    return true;
  }
};

/// What the left button does in a view, besides turning the camera or putting the crosshair. Edits
/// the model; one gesture, from press to release, is one step of the history.
class MouseTool
{
public:
  virtual ~MouseTool() = default;

  /// Whether it takes the gesture that begins here.
  virtual bool Press(const QPointF& place) = 0;
  virtual void Drag(const QPointF& place) = 0;
  virtual void Release(const QPointF& place) = 0;

  /// Takes the gesture back.
  virtual void Cancel() = 0;

  /// Whether the pointer is over something that can be grabbed.
  virtual bool IsOver(const QPointF&) const { return false; }

  /// Over the picture of its view.
  virtual void Paint(QPainter&) const {}
};

}

#endif
