#ifndef Varimarch_Readers_Times_h
#define Varimarch_Readers_Times_h

#include "Readers/VolumeFile.h"

#include <cstdint>
#include <string>
#include <vector>

namespace varimarch
{

/// Volumes that follow each other without stated times: 0, 1, 2 ...
/// @param count  number of volumes that a header states; at most MostTimes are offered
VolumeTimes NumberedTimes(std::int64_t count);

/// Volumes at even distances in time; numbered if the step is not a positive number.
VolumeTimes EvenTimes(std::int64_t count, double startSeconds, double stepSeconds);

/// Volumes at stated moments; numbered if these are not in ascending order.
VolumeTimes StatedTimes(const std::vector<double>& seconds);

/// Checks that a file has the time to read.
/// @throws std::runtime_error otherwise
void CheckTime(const std::string& path, const VolumeTimes& times, const ReadOptions& options);

/// Takes the times of a file, and checks that it has the one to read.
/// @throws std::runtime_error otherwise
void TakeTimes(
  const std::string& path, VolumeTimes times, const ReadOptions& options, Volume& volume);

/// Seconds of a unit of time, which may be in quotation marks; 0 for other texts.
double SecondsPerUnit(const std::string& unit);

/// The number of the time that lies nearest to a value.
std::int64_t NearestTime(const std::vector<double>& times, double value);

/// More volumes than any scanner makes; a header that states more is damaged.
constexpr std::int64_t MostTimes = 1 << 20;

}

#endif
