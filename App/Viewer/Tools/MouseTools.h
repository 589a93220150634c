#ifndef Varimarch_Viewer_MouseTools_h
#define Varimarch_Viewer_MouseTools_h

#include "Viewer/Tools/CutHandles.h"
#include "Viewer/Tools/MeasureTool.h"
#include "Viewer/Tools/MouseTool.h"

#include <QEvent>

#include <optional>

class QMouseEvent;

namespace varimarch
{

/// Action of the left button.
enum class LeftButton
{
  Turn, ///< turns the camera; in slices, moves the crosshair
  Walk, ///< looks around, and keys move the eye; in slices, moves the crosshair
  Brightness,
  Distance,
  Angle,
  CobbAngle,
  Box,
  Ellipse,
  Freehand,
  Curve,
  Arrow,
  Text,
  CutOut,
  KeepOnly,
};

/// The measurement that a button makes; empty for other actions.
std::optional<MeasureKind> MeasureOf(LeftButton button);

/// Tools of the 3D view: the chosen one, the handles of cuts, which take precedence while shown,
/// and window and level with Ctrl at any time. Esc reverts a gesture.
class MouseTools
{
public:
  MouseTools(SceneModel* model, ToolSurface& surface, const std::function<Camera()>& camera);

  void Choose(LeftButton button);
  void ShowCutHandles(bool shown) { this->handles.SetShown(shown); }

  /// Forgets what was begun, since the volume is another one.
  void Forget() { this->measure.Forget(); }

  bool Measures() const { return this->chosen == &this->measure; }

  /// Returns true if a tool handled the mouse or keyboard event.
  bool Take(QEvent* event);

  Qt::CursorShape Cursor(const QPointF& place) const;

  /// Paints over the image.
  void Paint(QPainter& painter) const;

private:
  // Each returns true if a tool handled the event.
  bool Press(QMouseEvent* mouse);
  bool Move(QMouseEvent* mouse);
  bool Release(QMouseEvent* mouse);
  bool Key(QEvent* event);
  bool Cancel();
  MouseTool* ToolFor(QMouseEvent* mouse);
  void SetActive(MouseTool* tool);

  CutHandles handles;
  MeasureTool measure;
  ScissorsTool scissors;
  BrightnessTool brightness;
  WalkTool walk;
  MouseTool* chosen = nullptr; ///< null: the camera turns
  MouseTool* active = nullptr; ///< the tool whose gesture is in progress
};

}

#endif
