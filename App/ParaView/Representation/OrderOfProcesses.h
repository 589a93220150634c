#ifndef Varimarch_OrderOfProcesses_h
#define Varimarch_OrderOfProcesses_h

#include "Core/Blocks/OwnerOrder.h"

#include <vector>

class vtkBoundingBox;
class vtkCamera;
class vtkCameraPass;
class vtkIceTCompositePass;
class vtkMatrix4x4;
class vtkMultiProcessController;
class vtkRenderer;
class vtkVolume;

namespace varimarch
{

// ParaView lays the pictures of processes over each other in the order of one box for each of them
// along the axes of the world. It finds no order for boxes that overlap, as those around two
// volumes or turned ones may, nor for boxes that do not touch.

/// The box in the world around a box of data, by which ParaView divides geometry among processes:
/// it is a little smaller, so that boxes that touch do not overlap by rounding. It is invalid if
/// the box of data is.
void TurnBounds(const double bounds[6], vtkMatrix4x4* worldFromData, double turned[6]);

/// Keeps the box of a volume's data on this process with the volume, for OrderOfProcesses.
void KeepDataBox(const double bounds[6], vtkVolume* volume);

/// The order in which the pictures of processes are to be laid over each other: the one that is
/// right for all visible volumes, or in which the fewest pixels may be wrong. All processes must
/// call this.
OwnerOrder OrderOfProcesses(vtkRenderer* renderer, vtkMultiProcessController* controller);

/// ParaView's pass that composites the pictures of processes, below any passes that process the
/// image; null if there is none.
vtkIceTCompositePass* CompositePassOf(vtkRenderer* renderer);

/// The camera's pass by which one process draws in ParaView's usual way, below any passes that
/// process the image; null if it draws in another way.
vtkCameraPass* UsualCameraPassOf(vtkRenderer* renderer);

/// Boxes in front of the eye, one for each process, which ParaView finds in this order.
/// @param processes  all of them, front to back
std::vector<vtkBoundingBox> BoxesInOrder(const std::vector<int>& processes, vtkCamera* camera);

}

#endif
