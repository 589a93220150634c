#ifndef Varimarch_CommandLine_UsageError_h
#define Varimarch_CommandLine_UsageError_h

#include <stdexcept>

namespace varimarch
{

/// A command line whose arguments do not fit together or do not fit the input. The program reports
/// the message, points to --help, and returns the exit code for bad usage.
class UsageError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

}

#endif
