#ifndef Varimarch_Benchmarks_CapturedErrors_h
#define Varimarch_Benchmarks_CapturedErrors_h

#include <functional>
#include <string>

namespace varimarch
{

/// The text that this process, with all its libraries, writes to its standard error while something
/// is done.
std::string ErrorsDuring(const std::function<void()>& act);

}

#endif
