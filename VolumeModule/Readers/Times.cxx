#include "Readers/Times.h"

#include "Readers/FileError.h"
#include "Readers/Parsing/HeaderText.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

namespace varimarch
{

VolumeTimes NumberedTimes(std::int64_t count)
{
  VolumeTimes times;
  times.values.resize(std::size_t(std::clamp<std::int64_t>(count, 1, MostTimes)));
  std::iota(times.values.begin(), times.values.end(), 0.0);
  return times;
}

VolumeTimes EvenTimes(std::int64_t count, double startSeconds, double stepSeconds)
{
  VolumeTimes times = NumberedTimes(count);
  const double start = std::isfinite(startSeconds) ? startSeconds : 0.0;
  if (std::isfinite(stepSeconds) && stepSeconds > 0.0 && times.values.size() > 1)
  {
    times.areSeconds = true;
    std::transform(times.values.begin(), times.values.end(), times.values.begin(),
      [&](double index) { return start + index * stepSeconds; });
  }
  return times;
}

VolumeTimes StatedTimes(const std::vector<double>& seconds)
{
  const bool areAscending = seconds.size() > 1 &&
    std::all_of(seconds.begin(), seconds.end(), [](double time) { return std::isfinite(time); }) &&
    std::adjacent_find(seconds.begin(), seconds.end(), std::greater_equal<>()) == seconds.end();
  return areAscending ? VolumeTimes{ seconds, true } : NumberedTimes(std::int64_t(seconds.size()));
}

void CheckTime(const std::string& path, const VolumeTimes& times, const ReadOptions& options)
{
  const auto count = std::int64_t(times.values.size());
  if (options.time < 0 || options.time >= count)
  {
    FailToRead(path,
      count == 1 ? "the time 0, since the file holds a single volume"
                 : "a time from 0 to " + std::to_string(count - 1),
      "the time " + std::to_string(options.time));
  }
}

void TakeTimes(
  const std::string& path, VolumeTimes times, const ReadOptions& options, Volume& volume)
{
  volume.times = std::move(times);
  CheckTime(path, volume.times, options);
}

double SecondsPerUnit(const std::string& unit)
{
  static const std::map<std::string, double> units = { { "s", 1.0 }, { "sec", 1.0 },
    { "second", 1.0 }, { "ms", 1e-3 }, { "msec", 1e-3 }, { "millisecond", 1e-3 }, { "us", 1e-6 },
    { "microsecond", 1e-6 }, { "nanosecond", 1e-9 }, { "min", 60.0 }, { "minute", 60.0 },
    { "hour", 3600.0 }, { "day", 86400.0 } };
  std::string name = LowerCase(Trimmed(unit));
  name.erase(std::remove(name.begin(), name.end(), '"'), name.end());
  if (name.size() > 3 && name.back() == 's')
  {
    name.pop_back();
  }
  const auto known = units.find(name);
  return known == units.end() ? 0.0 : known->second;
}

std::int64_t NearestTime(const std::vector<double>& times, double value)
{
  const auto nearest = std::min_element(times.begin(), times.end(),
    [&](double a, double b) { return std::abs(a - value) < std::abs(b - value); });
  return nearest - times.begin();
}

}
