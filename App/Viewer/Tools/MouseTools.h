#ifndef Varimarch_Viewer_MouseTools_h
#define Varimarch_Viewer_MouseTools_h

#include "Viewer/Tools/BrightnessTool.h"
#include "Viewer/Tools/CutHandles.h"
#include "Viewer/Tools/MeasureTool.h"
#include "Viewer/Tools/ScissorsTool.h"

#include <QEvent>

#include <optional>

class QMouseEvent;

namespace varimarch
{

/// What the left button does.
enum class LeftButton
{
  Turn, ///< in slices: the crosshair
  Brightness,
  Distance,
  Angle,
  Box,
  CutOut,
  KeepOnly,
};

/// What it measures, if anything.
std::optional<MeasureKind> MeasureOf(LeftButton button);

/// The tools of the volume's view: the one that was chosen; handles of cuts, which come first where
/// they are shown; and window and level with Ctrl, whatever was chosen. Esc takes a gesture back.
class MouseTools
{
public:
  MouseTools(SceneModel* model, const ToolSurface& surface, const std::function<Camera()>& camera);

  void Choose(LeftButton button);
  void ShowCutHandles(bool shown) { this->handles.SetShown(shown); }

  /// Whether an event of the mouse or the keyboard was for one of them.
  bool Take(QEvent* event);

  Qt::CursorShape Cursor(const QPointF& place) const;

  /// Over the picture.
  void Paint(QPainter& painter) const;

private:
  // Each says whether the event was for a tool.
  bool Press(QMouseEvent* mouse);
  bool Move(QMouseEvent* mouse);
  bool Release(QMouseEvent* mouse);
  bool Cancel();
  MouseTool* ToolFor(QMouseEvent* mouse);

  CutHandles handles;
  MeasureTool measure;
  ScissorsTool scissors;
  BrightnessTool brightness;
  MouseTool* chosen = nullptr; ///< none: the camera turns
  MouseTool* active = nullptr; ///< whose gesture goes on
};

}

#endif
