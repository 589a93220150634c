#ifndef Varimarch_Testing_LoopGaps_h
#define Varimarch_Testing_LoopGaps_h

#include <QElapsedTimer>
#include <QTimer>

#include <algorithm>

namespace varimarch
{

/// Watches an event loop: a timer that is due each millisecond tells how long the loop let it wait.
class LoopGaps
{
public:
  /// A gap that a user feels [ms].
  static constexpr double FeltMilliseconds = 50.0;

  LoopGaps()
  {
    QObject::connect(&this->timer, &QTimer::timeout, &this->timer, [this] { this->Note(); });
    this->timer.start(1);
    this->total.start();
    this->sinceLast.start();
  }

  double LongestMilliseconds() const { return this->longest; }

  /// The part of the time so far that gaps took which a user feels, [0, 1].
  double FeltPart()
  {
    this->Note();
    return this->felt / std::max(1e-6 * double(this->total.nsecsElapsed()), 1.0);
  }

private:
  void Note()
  {
    const double gap = 1e-6 * double(this->sinceLast.nsecsElapsed());
    this->sinceLast.start();
    this->longest = std::max(this->longest, gap);
    this->felt += gap > FeltMilliseconds ? gap : 0.0;
  }

  QTimer timer;
  QElapsedTimer total;
  QElapsedTimer sinceLast;
  double longest = 0.0;
  double felt = 0.0;
};

}

#endif
