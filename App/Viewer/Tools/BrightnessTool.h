#ifndef Varimarch_Viewer_BrightnessTool_h
#define Varimarch_Viewer_BrightnessTool_h

#include "Viewer/Model/SceneModel.h"
#include "Viewer/Tools/MouseTool.h"

#include <QCoreApplication>

namespace varimarch
{

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

}

#endif
