#ifndef Varimarch_Viewer_CurvedView_h
#define Varimarch_Viewer_CurvedView_h

#include "Scene/Slices/CurvedPicture.h"
#include "Viewer/Model/SceneModel.h"

#include <QPointF>
#include <QWidget>

#include <optional>

namespace varimarch
{

/// The volume along the last visible curve among the measurements. Straightened, the curve runs
/// from left to right through the middle; stretched, it keeps its bends towards one direction, and
/// all distances in the picture are right. At least 6 cm are seen across the curve: in a low view
/// the picture is narrower than the view. The context menu chooses, and the choice is kept for
/// the next start. A ruler shows the distance along the picture. Window, level and slab are those
/// of the slices. The left button moves the crosshair to the point that is clicked; the wheel, and
/// the arrow keys up and down, turn the cut about the curve.
class CurvedView : public QWidget
{
  Q_OBJECT

public:
  explicit CurvedView(SceneModel* model, QWidget* parent = nullptr);

  /// The curve that is shown; null without one.
  const CurvePath* Path() const { return this->path ? &*this->path : nullptr; }

  /// The point at a place, in world space [mm]. Empty beside the curve.
  std::optional<glm::dvec3> PointAt(const QPointF& place) const;

  /// High enough for a vessel and some centimetres around it.
  QSize sizeHint() const override { return { 400, 200 }; }

signals:
  /// Describes the voxel under the pointer and its distance along the curve, for the status bar.
  void Pointed(const QString& text);

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  void MakeMenu();
  void SetStretched(bool isStretched);
  void Update(ScenePart part);
  void FindCut();
  CurvedRequest Request() const;
  void DrawVoxels(QPainter& painter) const;
  void DrawRuler(QPainter& painter) const;
  void DrawCurve(QPainter& painter) const;
  void DrawCrosshair(QPainter& painter) const;
  void MoveCrosshair(const QPointF& place);
  void Turn(double degrees);
  double AlongCurveMm(double x) const;

  SceneModel* model;
  std::optional<CurvePath> path; ///< empty without a curve of some length
  std::optional<CurvePath> cut;  ///< the path of the picture: that curve, or the stretched one
  bool stretched;
  int gesture = SceneModel::NoGesture;
};

}

#endif
