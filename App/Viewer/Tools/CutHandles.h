#ifndef Varimarch_Viewer_CutHandles_h
#define Varimarch_Viewer_CutHandles_h

#include "Viewer/Model/SceneModel.h"
#include "Viewer/Tools/CutDragging.h"
#include "Viewer/Tools/MouseTool.h"

#include <QCoreApplication>

#include <optional>

namespace varimarch
{

/// Handles of the cuts: discs push planes, arrows turn them, and the faces of the box crop it. They
/// are painted over the image, not rendered with it, so that the volume need not be rendered again
/// and exports and comparisons do not show them.
class CutHandles : public MouseTool
{
  Q_DECLARE_TR_FUNCTIONS(CutHandles)

public:
  CutHandles(SceneModel* model, const ToolSurface& surface);

  /// Hidden handles cannot be grabbed.
  void SetShown(bool newShown) { this->shown = newShown; }

  /// Sets the pointer position; the handle under it is drawn larger.
  void Hover(const QPointF& place) { this->pointer = place; }

  bool Press(const QPointF& place) override;
  void Drag(const QPointF& place) override;
  void Release(const QPointF& place) override;
  void Cancel() override;
  bool IsOver(const QPointF& place) const override { return bool(this->HandleAt(place)); }
  void Paint(QPainter& painter) const override;

private:
  std::optional<CutHandle> HandleAt(const QPointF& place) const;
  void PaintPlanes(QPainter& painter, const PictureFrame& frame) const;
  void PaintBox(QPainter& painter, const PictureFrame& frame) const;
  void PaintHandle(QPainter& painter, const CutHandle& handle, const PictureFrame& frame) const;
  vtkImageData* Image() const { return this->model->CurrentStudy()->volume.image; }

  SceneModel* model;
  const ToolSurface& surface;
  bool shown = false;
  QPointF pointer;
  std::optional<CutHandle> grabbed;
  QPointF pressed;
  SceneCuts before;
  int gesture = SceneModel::NoGesture;
};

}

#endif
