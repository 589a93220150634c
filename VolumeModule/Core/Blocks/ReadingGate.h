#ifndef Varimarch_Core_Blocks_ReadingGate_h
#define Varimarch_Core_Blocks_ReadingGate_h

#include <atomic>
#include <cstdint>

namespace varimarch
{

/// Memory of this process that is resident now, with that of mapped files [bytes].
std::uint64_t ResidentBytes();

/// Holds the threads that march through voxels of a file when the process has too many of them in
/// memory, until another thread has dropped some. Where the system has the file in its cache, rays
/// bring 50 MB a millisecond, so that they have to look themselves. There is one gate for the
/// process, whose memory it is about.
class ReadingGate
{
public:
  static ReadingGate& OfProcess();

  /// Opens the gate until the process has more than this in memory [bytes]. Whoever sets a bound
  /// sets it again soon: threads wait without a limit.
  void OpenUntil(std::uint64_t bytes)
  {
    this->mostBytes = bytes;
    this->isClosed = false;
  }

  /// Opens the gate for good.
  void Open() { this->OpenUntil(UINT64_MAX); }

  /// True if threads wait, or will.
  bool IsClosed() const { return this->isClosed; }

  /// True if a thread came to it, with a bound, or waited in the last tenth of a second.
  bool IsInUse() const;

  /// Waits while the gate is closed.
  void Pass()
  {
    if (this->mostBytes.load(std::memory_order_relaxed) != UINT64_MAX)
    {
      this->PassBounded();
    }
  }

private:
  void PassBounded();

  std::atomic<std::uint64_t> mostBytes = UINT64_MAX;
  std::atomic<std::int64_t> lookedAt = 0; ///< the time of the last look [ms]
  std::atomic<bool> isClosed = false;
};

}

#endif
