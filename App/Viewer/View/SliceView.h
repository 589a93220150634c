#ifndef Varimarch_Viewer_SliceView_h
#define Varimarch_Viewer_SliceView_h

#include "Scene/Slices/SlicePicture.h"
#include "Viewer/Model/MeasureTexts.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/Model/SegmentEditor.h"
#include "Viewer/Tools/MouseTools.h"
#include "Viewer/View/SliceCorners.h"
#include "Viewer/View/SlicePlacement.h"

#include <QObject>
#include <QPoint>
#include <QPointer>
#include <QTimer>
#include <QWidget>

#include <array>
#include <deque>
#include <optional>

class QWidget;

namespace varimarch
{

/// Paints widgets whose images take long, each in a turn of the event loop of its own, so that the
/// window reacts between them. Qt paints all widgets that have changed in one turn. A widget that
/// awaits its turn should paint nothing that takes long.
class DrawingTurns : public QObject
{
  Q_OBJECT

public:
  explicit DrawingTurns(QObject* parent = nullptr);

  /// Puts a widget at the end of the queue, unless it is in it.
  void Await(QWidget* widget);

  /// True until the turn of the widget begins.
  bool Awaits(const QWidget* widget) const;

private:
  void PaintNext();

  std::deque<QPointer<QWidget>> queue;
  QTimer turn;
};

/// A slice of the volume through the crosshair, which all slices share. The left button moves the
/// crosshair, turns the other two planes by its arms, or measures, the right button drags window
/// and level, the middle button drags the slice, the wheel scrolls through the slices, and Ctrl
/// with the wheel zooms. The slice that was clicked last takes keys: the arrows and the page keys
/// scroll, + and - zoom, a number chooses a usual window, see ChooseWindow.
class SliceView
  : public QWidget
  , public ToolSurface
{
  Q_OBJECT

public:
  SliceView(SceneModel* model, SlicePlane plane, QWidget* parent = nullptr);

  SlicePlane Plane() const { return this->plane; }

  /// Sets the action of the left button. For tools of the 3D view it moves the crosshair.
  void SetTool(LeftButton button);

  /// The left button edits segments while a tool of the editor is chosen.
  void SetSegmentEditor(SegmentEditor* newEditor);

  /// A slice of a new volume is painted in its turn; without turns it is painted with the window.
  void SetTurns(DrawingTurns* newTurns) { this->turns = newTurns; }

  /// Sets the texts at the edges; at first all are shown.
  void SetCornerTexts(const CornerTexts& shown);

  PictureFrame Frame() const override;

  /// Never empty; world space [mm].
  std::optional<std::array<double, 3>> PointAt(const QPointF& place) const override;
  QPointF PlaceOf(const std::array<double, 3>& pointMm) const;

signals:
  /// Describes the voxel under the pointer, for the status bar; empty beside the volume.
  void Pointed(const QString& text);

  /// The user wants to see this view alone, or all views again.
  void DoubleClicked();

protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

private:
  std::optional<glm::dvec3> Through() const override;
  bool Shows(const std::vector<glm::dvec3>& points) const override;
  void AskForWords(const QPointF& place, const std::function<void(const QString&)>& take) override;
  void Update(ScenePart part);
  void DrawMeasuresOfSlice(QPainter& painter, const std::vector<QRectF>& taken) const;
  SliceRequest Request() const;
  void DrawVoxels(QPainter& painter) const;
  void DrawOverlays(QPainter& painter, SliceRequest request) const;
  void DrawSegments(QPainter& painter, const SliceRequest& request) const;
  void DrawCrosshair(QPainter& painter) const;
  void DrawBrush(QPainter& painter) const;
  bool PressSegment(const QMouseEvent* event);
  bool Draws() const; ///< the left button edits segments
  void DragWindowLevel(const QPoint& moved);
  void DragSlice(const QPoint& moved);
  void Zoom(double notches);
  void Scroll(double slices);
  void ResetZoom();
  void FollowPointer(const QPointF& place);
  SlicePlacement Placement() const;
  SliceAxes Axes() const;
  CrosshairArms Arms() const;
  std::array<double, 3> Crosshair() const;
  SliceGrays Grays() const;
  void SetCrosshair(const std::array<double, 3>& pointMm, int gesture);

  SceneModel* model;
  SlicePlane plane;
  SliceZoom zoom;
  CornerTexts corners = AllCornerTexts();
  int gesture = SceneModel::NoGesture;
  MeasureTool measure;
  bool measuring = false;    ///< the left button measures
  bool toolIsActive = false; ///< a gesture of the measure tool is in progress
  MeasureTexts texts;
  SegmentEditor* segmentEditor = nullptr; ///< null before it is set
  DrawingTurns* turns = nullptr;          ///< null before they are set
  bool isDrawing = false;                 ///< a stroke is in progress
  QPointF pointer;
  QPoint pressed;
  std::array<double, 2> pressedWindowLevel = {};
  QPointF pressedShiftMm;
  std::optional<CrosshairArms> draggedArms; ///< empty while no arm is dragged
};

}

#endif
