#ifndef Varimarch_Viewer_MouseTool_h
#define Varimarch_Viewer_MouseTool_h

#include "Viewer/Model/SceneModel.h"
#include "Viewer/View/PictureFrame.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QPointF>
#include <QPolygonF>
#include <QString>
#include <QTimer>

#include <glm/vec3.hpp>

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <vector>

class QKeyEvent;
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

/// Window and level of the volume. A horizontal drag scales the transfer function about its centre;
/// a vertical drag shifts it along the values. As in slices, down is brighter.
class BrightnessTool : public MouseTool
{
  Q_DECLARE_TR_FUNCTIONS(BrightnessTool)

public:
  BrightnessTool(SceneModel* model, const ToolSurface& surface);

  bool Press(const QPointF& place) override;
  void Drag(const QPointF& place) override;
  void Release(const QPointF&) override {}
  void Cancel() override;

private:
  SceneModel* model;
  const ToolSurface& surface;
  QPointF pressed;
  Look before;
  int gesture = SceneModel::NoGesture;
};

/// Centre of the value range over which the opacity of a look varies.
double MiddleOfOpacities(const Look& look);

/// Cuts through the depth of the volume along an outline drawn by hand.
class ScissorsTool : public MouseTool
{
  Q_DECLARE_TR_FUNCTIONS(ScissorsTool)

public:
  /// @param camera  returns the camera of the view, with a pose
  ScissorsTool(
    SceneModel* model, const ToolSurface& surface, const std::function<Camera()>& camera);

  /// True keeps the inside of the outline, false the outside.
  void SetKeepsInside(bool newKeepsInside) { this->keepsInside = newKeepsInside; }

  bool Press(const QPointF& place) override;
  void Drag(const QPointF& place) override;
  void Release(const QPointF& place) override;
  void Cancel() override { this->drawn.clear(); }
  void Paint(QPainter& painter) const override;

private:
  SceneModel* model;
  const ToolSurface& surface;
  std::function<Camera()> camera;
  bool keepsInside = false;
  QPolygonF drawn; ///< points of the outline in the view; empty without a gesture
};

/// Walks through the volume as in a game: W, A, S, D or the arrow keys move the eye while they are
/// held, E and Q or the page keys raise and lower it, Shift makes it four times as fast, and a drag
/// of the mouse looks around. All from the first key until no key is held is one undo step. The
/// projection becomes a perspective.
class WalkTool : public MouseTool
{
  Q_DECLARE_TR_FUNCTIONS(WalkTool)

public:
  /// @param camera  the camera of the view, with its pose
  WalkTool(SceneModel* model, const ToolSurface& surface, std::function<Camera()> camera);

  /// Returns true if a key event is one of the tool's. Such keys are no shortcuts.
  bool TakeKey(QKeyEvent* event);

  /// Releases all keys, as when the view loses the focus.
  void Stand();

  bool Press(const QPointF& place) override;
  void Drag(const QPointF& place) override;
  void Release(const QPointF&) override {}
  void Cancel() override;

private:
  void Step();
  void Place(const Camera& placement);

  SceneModel* model;
  const ToolSurface& surface;
  std::function<Camera()> camera;
  std::map<int, bool> held; ///< keys, and whether Shift was held with them
  QTimer timer;             ///< timer of the steps
  QElapsedTimer sinceStep;
  QPointF pressed;
  Camera before; ///< the camera when the mouse was pressed
  int gesture = SceneModel::NoGesture;
};

/// The pose after a step to the right, up and forwards [mm]. Up is across the view and as near to
/// the camera's view-up as possible.
CameraPose Walked(const CameraPose& pose, const glm::dvec3& stepMm);

/// The pose that looks further to the right and further up, about the camera's view-up, but not
/// beyond 85 degrees from the horizon.
CameraPose LookingAround(const CameraPose& pose, double rightwardsDegrees, double upwardsDegrees);

}

#endif
