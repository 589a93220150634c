#include "Readers/Decoder/Program/MemoryLimit.h"

#include <algorithm>
#include <fstream>

#include <sys/resource.h>
#include <unistd.h>

namespace varimarch
{
namespace
{

/// Private memory that this process has mapped [bytes], which RLIMIT_DATA counts; see proc(5).
double MappedDataBytes()
{
  std::ifstream file("/proc/self/statm");
  double pages = 0.0;
  for (int field = 0; field < 6; ++field)
  {
    file >> pages;
  }
  return pages * double(sysconf(_SC_PAGESIZE));
}

}

void LimitMemory(double bytes)
{
  static const double atFirst = MappedDataBytes();
  rlimit limit = {};
  getrlimit(RLIMIT_DATA, &limit);
  const double most = atFirst + bytes;
  limit.rlim_cur = most < double(limit.rlim_max) ? rlim_t(most) : limit.rlim_max;
  setrlimit(RLIMIT_DATA, &limit);
}

}
