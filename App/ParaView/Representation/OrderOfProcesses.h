#ifndef Varimarch_OrderOfProcesses_h
#define Varimarch_OrderOfProcesses_h

#include <optional>
#include <utility>

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

/// Keeps the box of a volume's data on this process with the volume, for OrderProcesses.
void KeepDataBox(const double bounds[6], vtkVolume* volume);

/// Lets ParaView lay the pictures of processes over each other in the order that is right for all
/// visible volumes, or in which the fewest pixels may be wrong. All processes must call this.
/// @return  two processes of which each may have a part in front of one of the other's; none if the
///          order is right
std::optional<std::pair<int, int>> OrderProcesses(
  vtkRenderer* renderer, vtkMultiProcessController* controller);

}

#endif
