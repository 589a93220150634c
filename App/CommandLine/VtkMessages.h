#ifndef Varimarch_CommandLine_VtkMessages_h
#define Varimarch_CommandLine_VtkMessages_h

#include <string>

namespace varimarch
{

/// From now on VTK's warnings go to stderr, one line each, and its first error is kept for
/// ThrowIfVtkReportedError instead of being printed.
void CollectVtkMessages();

/// @throws std::runtime_error with the first error that VTK has reported since the last call
void ThrowIfVtkReportedError();

}

#endif
