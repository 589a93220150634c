#ifndef Varimarch_SearchOfProcesses_h
#define Varimarch_SearchOfProcesses_h

#include "Tolerance/SharedSearch.h"

#include <vector>

class vtkMultiProcessController;

namespace varimarch
{

/// The communication of a search for steps in which all processes of a controller take part.
/// @param order  all processes, front to back, the same on all of them
SearchingProcesses SearchOfProcesses(vtkMultiProcessController* controller, std::vector<int> order);

}

#endif
