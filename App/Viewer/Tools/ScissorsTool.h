#ifndef Varimarch_Viewer_ScissorsTool_h
#define Varimarch_Viewer_ScissorsTool_h

#include "Viewer/Model/SceneModel.h"
#include "Viewer/Tools/MouseTool.h"

#include <QCoreApplication>
#include <QPolygonF>

#include <functional>

namespace varimarch
{

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

}

#endif
