#include "Core/Blocks/ReadingGate.h"

#include <chrono>
#include <cstdio>
#include <thread>
#include <unistd.h>

namespace varimarch
{
namespace
{

std::int64_t Milliseconds()
{
  return std::chrono::duration_cast<std::chrono::milliseconds>(
    std::chrono::steady_clock::now().time_since_epoch())
    .count();
}

}

std::uint64_t ResidentBytes()
{
  unsigned long long all = 0;
  unsigned long long resident = 0;
  if (std::FILE* const file = std::fopen("/proc/self/statm", "r"))
  {
    if (std::fscanf(file, "%llu %llu", &all, &resident) != 2)
    {
      resident = 0;
    }
    std::fclose(file);
  }
  return resident * std::uint64_t(sysconf(_SC_PAGESIZE));
}

ReadingGate& ReadingGate::OfProcess()
{
  static ReadingGate gate;
  return gate;
}

bool ReadingGate::IsInUse() const
{
  return Milliseconds() - this->lookedAt < 100;
}

// Threads sleep, since a lock that is held while the process is forked would stay locked in the
// child.
void ReadingGate::PassBounded()
{
  const std::int64_t now = Milliseconds();
  if (this->lookedAt.exchange(now) != now && ResidentBytes() > this->mostBytes)
  {
    this->isClosed = true;
  }
  while (this->isClosed)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    this->lookedAt = Milliseconds();
  }
}

}
