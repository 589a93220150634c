#ifndef Varimarch_Viewer_CutDragging_h
#define Varimarch_Viewer_CutDragging_h

#include "Scene/Scene.h"
#include "Viewer/View/PictureFrame.h"

#include <array>
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

}

#endif
