#ifndef Varimarch_Testing_LoopGaps_h
#define Varimarch_Testing_LoopGaps_h

#include <QElapsedTimer>
#include <QTimer>

#include <algorithm>
#include <ctime>

namespace varimarch
{

/// Watches an event loop: a timer that is due each millisecond tells how long the loop let it wait,
/// and how long its thread worked meanwhile, which does not depend on other programs.
class LoopGaps
{
public:
  LoopGaps()
  {
    QObject::connect(&this->timer, &QTimer::timeout, &this->timer, [this] { this->Note(); });
    this->timer.start(1);
    this->sinceLast.start();
  }

  double LongestMilliseconds() const { return this->longest; }

  /// The longest work of the thread between two turns of the loop.
  double MostWorkMilliseconds() const { return this->mostWork; }

private:
  static double WorkOfThread()
  {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
  }

  void Note()
  {
    const double gap = 1e-6 * double(this->sinceLast.nsecsElapsed());
    this->sinceLast.start();
    this->longest = std::max(this->longest, gap);
    const double work = WorkOfThread();
    this->mostWork = std::max(this->mostWork, work - this->workBefore);
    this->workBefore = work;
  }

  QTimer timer;
  QElapsedTimer sinceLast;
  double longest = 0.0;
  double workBefore = WorkOfThread();
  double mostWork = 0.0;
};

}

#endif
