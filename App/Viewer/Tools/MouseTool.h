#ifndef Varimarch_Viewer_MouseTool_h
#define Varimarch_Viewer_MouseTool_h

#include "Viewer/View/PictureFrame.h"

#include <QPointF>
#include <QString>

#include <array>
#include <functional>
#include <optional>
#include <vector>

class QPainter;

namespace varimarch
{

/// The view that a tool works in.
class ToolSurface
{
public:
  virtual ~ToolSurface() = default;

  virtual PictureFrame Frame() const = 0;

  /// The visible point at a position, in world space [mm]; empty if nothing is visible there.
  virtual std::optional<std::array<double, 3>> PointAt(const QPointF& place) const = 0;

  /// Unit normal of a slice; empty for the 3D view.
  virtual std::optional<glm::dvec3> Through() const { return std::nullopt; }

  /// True if the view shows something that reaches from the first to the last of some points [mm].
  virtual bool Shows(const std::vector<glm::dvec3>&) const { return true; }

  /// Asks the user for words, which may be empty, without waiting for them.
  virtual void AskForWords(
    const QPointF& place, const std::function<void(const QString&)>& take) = 0;
};

/// An action of the left mouse button besides turning the camera or moving the crosshair. It edits
/// the model; one gesture, from press to release, is one undo step.
class MouseTool
{
public:
  virtual ~MouseTool() = default;

  /// Returns true if the tool takes the gesture that begins here.
  virtual bool Press(const QPointF& place) = 0;
  virtual void Drag(const QPointF& place) = 0;
  virtual void Release(const QPointF& place) = 0;

  /// Reverts the gesture.
  virtual void Cancel() = 0;

  /// True if the pointer is over something that can be grabbed.
  virtual bool IsOver(const QPointF&) const { return false; }

  /// Paints over the image of the view.
  virtual void Paint(QPainter&) const {}
};

}

#endif
