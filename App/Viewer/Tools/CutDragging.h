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
  TurnPlane, ///< the tip of an arrow towards what is cut away
  MoveFace,  ///< a disc on a face of the box
  MoveBox,   ///< a disc in its middle, while it is smaller than the volume
};

/// What the mouse can grab of the cuts.
struct CutHandle
{
  CutHandleKind kind;
  int index; ///< of the plane, or of the face as in SceneCuts::box
  std::array<double, 3> pointMm;
};

/// Where a plane is grabbed: at its own point, or, where that lies beside the volume, at one within
/// reach. World space [mm].
glm::dvec3 PlaneFoot(const CutPlane& plane, vtkImageData* image);

/// In the order in which they are grabbed where they lie over each other.
std::vector<CutHandle> HandlesOf(
  const SceneCuts& cuts, vtkImageData* image, const PictureFrame& frame);

/// A drag of the mouse over a picture.
struct MouseDrag
{
  QPointF from;
  QPointF to;
  PictureFrame frame;
};

/// The cuts after a handle is dragged; planes and faces stay within the volume.
/// @param cuts, handle  as they were when the drag began
SceneCuts Dragged(
  const SceneCuts& cuts, const CutHandle& handle, const MouseDrag& drag, vtkImageData* image);

}

#endif
