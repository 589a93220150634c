#ifndef Varimarch_Viewer_ScissorsTool_h
#define Varimarch_Viewer_ScissorsTool_h

#include "Viewer/Model/SceneModel.h"
#include "Viewer/Tools/MouseTool.h"

#include <QCoreApplication>
#include <QPolygonF>

#include <functional>

namespace varimarch
{

/// An outline drawn by hand cuts through the depth of the volume.
class ScissorsTool : public MouseTool
{
  Q_DECLARE_TR_FUNCTIONS(ScissorsTool)

public:
  /// @param camera  of the picture that is drawn on, with a pose
  ScissorsTool(
    SceneModel* model, const ToolSurface& surface, const std::function<Camera()>& camera);

  /// Whether what is inside stays, or what is outside.
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
  QPolygonF drawn; ///< places; empty without a gesture
};

}

#endif
