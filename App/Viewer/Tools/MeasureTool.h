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

/// Measures in a view. What was measured before is dragged by its points.
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
  /// One of the points of something measured.
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
  bool isNew = false; ///< what is grabbed was made by this gesture
  Point pressed = {};
  /// The first arm of an angle whose second is still to come; the vertex is its second point.
  std::optional<std::array<Point, 2>> arm;
};

}

#endif
