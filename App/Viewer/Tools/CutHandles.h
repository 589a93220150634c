#ifndef Varimarch_Viewer_CutHandles_h
#define Varimarch_Viewer_CutHandles_h

#include "Scene/Model/Scene.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/Tools/MouseTool.h"
#include "Viewer/View/PictureFrame.h"

#include <QCoreApplication>

#include <array>
#include <optional>
#include <vector>

class vtkImageData;

namespace varimarch
{

enum class CutHandleKind
{
  PushPlane, ///< a disc on the plane
  TurnPlane, ///< the tip of an arrow towards the side that is cut away
  MoveFace,  ///< a disc on a face of the box
  MoveBox,   ///< a disc at the centre of the box, if the box is smaller than the volume
};

/// A handle of a cut that the mouse can grab.
struct CutHandle
{
  CutHandleKind kind;
  int index; ///< index of the plane, or of the face in SceneCuts::box
  std::array<double, 3> pointMm;
};

/// The point at which a plane is grabbed, in world space [mm]: the plane's own point, or one near
/// the volume if that point lies outside.
glm::dvec3 PlaneFoot(const CutPlane& plane, vtkImageData* image);

/// All handles. Where handles overlap, the first one is grabbed.
std::vector<CutHandle> HandlesOf(
  const SceneCuts& cuts, vtkImageData* image, const PictureFrame& frame);

/// A mouse drag over a view.
struct MouseDrag
{
  QPointF from;
  QPointF to;
  PictureFrame frame;
};

/// The cuts after a handle was dragged. Planes and faces stay within the volume.
/// @param cuts, handle  at the start of the drag
SceneCuts Dragged(
  const SceneCuts& cuts, const CutHandle& handle, const MouseDrag& drag, vtkImageData* image);

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
