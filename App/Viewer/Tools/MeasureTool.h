#ifndef Varimarch_Viewer_MeasureTool_h
#define Varimarch_Viewer_MeasureTool_h

#include "Viewer/Model/SceneModel.h"
#include "Viewer/Tools/MouseTool.h"

#include <QCoreApplication>

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace varimarch
{

/// Makes measurements and annotations in a view. Each press begins a line that is dragged, until
/// there are all points of the kind; boxes, ellipses and outlines are drawn in one drag, and every
/// press adds a point to a curve. Points of earlier ones can be dragged.
class MeasureTool : public MouseTool
{
  Q_DECLARE_TR_FUNCTIONS(MeasureTool)

public:
  using Point = std::array<double, 3>;

  MeasureTool(SceneModel* model, ToolSurface& surface);

  /// Sets the kind to make. The next press begins a new one, also of curves.
  void SetKind(MeasureKind newKind);

  /// Forgets the points of what was begun, since the volume is another one.
  void Forget();

  bool Press(const QPointF& place) override;
  void Drag(const QPointF& place) override;
  void Release(const QPointF& place) override;
  void Cancel() override;
  bool IsOver(const QPointF& place) const override { return bool(this->PointNear(place)); }
  void Paint(QPainter& painter) const override;

private:
  /// Identifies a point of a measurement.
  struct PointId
  {
    int measure;
    int point;
  };

  std::optional<PointId> PointNear(const QPointF& place) const;
  bool Continues(const Scene& scene) const;
  void Begin(const Point& first);
  void BeginMeasure(std::vector<Point> points);
  void ContinueCurve(const Point& point);
  void MoveGrabbed(const Point& to);
  void Reshape(const Point& to);
  void ForgetUndone();
  bool IsEmpty() const;
  void AskForWords(const QPointF& place);
  void Edit(const std::function<void(Scene&)>& change);

  SceneModel* model;
  ToolSurface& surface;
  MeasureKind kind = MeasureKind::Distance;
  std::size_t countBefore = 0; ///< measurements when the kind was chosen, or the volume
  int gesture = SceneModel::NoGesture;
  int stepsBefore = 0; ///< undo steps before this gesture
  std::optional<PointId> grabbed;
  bool isNew = false; ///< true if this gesture made the grabbed measurement
  Point pressed = {};
  std::vector<Point> begun; ///< points of a measurement that lacks others
};

}

#endif
