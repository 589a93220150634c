#ifndef Varimarch_Viewer_TimeSpeed_h
#define Varimarch_Viewer_TimeSpeed_h

#include "Scene/VolumeLoading.h"

#include <QString>

#include <vector>

namespace varimarch
{

/// How fast the times of a scan follow each other.
struct TimeSpeed
{
  double timesPerSecond = 0.0; ///< 0: as they were acquired, which needs times in seconds

  bool IsAsAcquired() const { return this->timesPerSecond == 0.0; }
};

/// Seconds from one time to the next. The last one stays as long as that before it.
/// @param times  several; in seconds if the speed is that of acquisition
double SecondsOfTime(const LoadedTimes& times, int time, TimeSpeed speed);

/// The times that the pictures of a movie show, counted from 0. Each time is shown at least once.
/// @throws std::runtime_error with one sentence if the movie would last more than an hour
std::vector<int> TimesOfMovie(const LoadedTimes& times, TimeSpeed speed, double picturesPerSecond);

/// A time with its unit and its number, such as "1.40 s, 3 of 20".
QString TimeText(const LoadedTimes& times, int time);

}

#endif
