#ifndef Varimarch_Viewer_MeasureTool_h
#define Varimarch_Viewer_MeasureTool_h

#include "Viewer/Model/SceneModel.h"
#include "Viewer/Tools/MouseTool.h"

#include <QCoreApplication>

#include <array>
#include <optional>

namespace varimarch
{

enum class MeasureKind
{
  Distance, ///< drag from one end to the other
  Angle,    ///< drag from the end of one arm to the vertex, then press at the end of the other
  Box,      ///< drag from corner to corner
};

/// Makes measurements in a view. Points of earlier ones can be dragged.
class MeasureTool : public MouseTool
{
  Q_DECLARE_TR_FUNCTIONS(MeasureTool)

public:
  using Point = std::array<double, 3>;

  MeasureTool(SceneModel* model, const ToolSurface& surface);

  void SetKind(MeasureKind newKind);

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
    MeasureKind kind;
    int measure;
    int point;
  };

  std::optional<PointId> PointNear(const QPointF& place) const;
  void Begin(const Point& first);
  void MoveGrabbed(const Point& to);
  void MakeBox(const Point& to);
  void Edit(const std::function<void(Scene&)>& change);

  SceneModel* model;
  const ToolSurface& surface;
  MeasureKind kind = MeasureKind::Distance;
  int gesture = SceneModel::NoGesture;
  std::optional<PointId> grabbed;
  bool isNew = false; ///< true if this gesture made the grabbed measurement
  Point pressed = {};
  /// First arm of an unfinished angle: its end, then the vertex.
  std::optional<std::array<Point, 2>> arm;
};

}

#endif
