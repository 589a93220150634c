#ifndef Varimarch_Core_Quality_MarchWork_h
#define Varimarch_Core_Quality_MarchWork_h

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

namespace varimarch
{

/// The work of marches, which may end them before all of their pixels are there: because they take
/// more than they may, or because nobody wants them any more. Work is time of the processors that
/// this process takes, in all of its threads: unlike time that passes, it is about the same on a
/// busy computer.
class MarchWork
{
public:
  /// Tells how much of a march is done, [0, 1], and returns false if it is not wanted any more.
  using Question = std::function<bool(double part)>;

  /// @param mostSeconds  time of processors
  /// @param isWanted     asked now and then, by the thread that calls this
  MarchWork(double mostSeconds, Question isWanted);

  /// Begins a march.
  void Begin(int packets);
  /// Ends a packet of rays. Called by any thread.
  void EndPacket();
  /// True if the march shall end without its pixels. Called by any thread.
  bool IsStopped() const { return this->isUsedUp || this->isUnwanted; }

  /// Time of processors since this was made [s].
  double Seconds() const;
  bool IsUsedUp() const { return this->isUsedUp; }
  bool IsUnwanted() const { return this->isUnwanted; }

private:
  double mostSeconds;
  Question isWanted;
  std::thread::id owner;
  double startSeconds;
  std::chrono::steady_clock::time_point askedAt = {};
  std::atomic<int> packets = 1; ///< The number of packets of the march.
  std::atomic<int> packetsDone = 0;
  std::atomic<bool> isUsedUp = false;
  std::atomic<bool> isUnwanted = false;
};

}

#endif
