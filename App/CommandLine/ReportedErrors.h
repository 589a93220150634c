#ifndef Varimarch_CommandLine_ReportedErrors_h
#define Varimarch_CommandLine_ReportedErrors_h

namespace varimarch
{

/// Redirects VTK's messages until the program ends: warnings go to stderr, one line each, and the
/// first error is kept for ThrowIfVtkReportedError instead of being printed.
void CollectVtkMessages();

/// Turns VTK's errors into an exception.
/// @throws std::runtime_error with the first error that VTK has reported since the last call
void ThrowIfVtkReportedError();

}

#endif
