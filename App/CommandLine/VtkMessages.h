#ifndef Varimarch_CommandLine_VtkMessages_h
#define Varimarch_CommandLine_VtkMessages_h

#include <string>

namespace varimarch
{

/// Redirects VTK's messages: warnings go to stderr, one line each, and the first error is kept for
/// ThrowIfVtkReportedError instead of being printed.
void CollectVtkMessages();

/// Turns VTK's errors into an exception.
/// @throws std::runtime_error with the first error that VTK has reported since the last call
void ThrowIfVtkReportedError();

/// During its lifetime, VTK's errors and warnings are neither printed nor thrown, but kept here.
class VtkMessageScope
{
public:
  VtkMessageScope();
  ~VtkMessageScope();
  VtkMessageScope(const VtkMessageScope&) = delete;
  void operator=(const VtkMessageScope&) = delete;

  /// The first message since construction; empty: none.
  std::string First() const;
};

}

#endif
