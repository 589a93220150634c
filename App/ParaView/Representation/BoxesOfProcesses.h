#ifndef Varimarch_BoxesOfProcesses_h
#define Varimarch_BoxesOfProcesses_h

#include <optional>
#include <utility>

class vtkMatrix4x4;
class vtkMultiProcessController;
class vtkRenderer;

namespace varimarch
{

// ParaView composites the pictures of processes in the order of boxes around what each of them has,
// and finds no order for boxes that overlap.

/// The box in the world around a box of data, for the order of processes: it is a little smaller,
/// so that boxes that touch do not overlap by rounding. It is invalid if the box of data is.
void TurnBounds(const double bounds[6], vtkMatrix4x4* worldFromData, double turned[6]);

/// The first two processes whose boxes around all of their visible volumes overlap. All processes
/// must call this.
std::optional<std::pair<int, int>> OverlappingProcesses(
  vtkRenderer* renderer, vtkMultiProcessController* controller);

}

#endif
