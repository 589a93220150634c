#include "Viewer/Model/TimeSpeed.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace varimarch
{

namespace
{

constexpr double LongestMovieSeconds = 3600.0;

struct TimeTexts
{
  Q_DECLARE_TR_FUNCTIONS(TimeTexts)
};

}

double SecondsOfTime(const LoadedTimes& times, int time, TimeSpeed speed)
{
  if (!speed.IsAsAcquired())
  {
    return 1.0 / speed.timesPerSecond;
  }
  const std::size_t first = std::min(std::size_t(time), times.values.size() - 2);
  return times.values[first + 1] - times.values[first];
}

std::vector<int> TimesOfMovie(const LoadedTimes& times, TimeSpeed speed, double picturesPerSecond)
{
  std::vector<int> shown;
  double end = 0.0;
  for (int time = 0; time < int(times.values.size()); ++time)
  {
    end += SecondsOfTime(times, time, speed);
    if (!(end <= LongestMovieSeconds))
    {
      throw std::runtime_error(
        TimeTexts::tr("A movie lasts at most an hour, and this one would be longer. Choose a speed "
                      "beside the slider of the times.")
          .toStdString());
    }
    const auto count = std::size_t(std::llround(end * picturesPerSecond));
    shown.resize(std::max(count, shown.size() + 1), time);
  }
  return shown;
}

QString TimeText(const LoadedTimes& times, int time)
{
  const QLocale locale;
  const QString number = TimeTexts::tr("%1 of %2").arg(time + 1).arg(times.values.size());
  return times.areSeconds ? TimeTexts::tr("%1 s, %2")
                              .arg(locale.toString(times.values[std::size_t(time)], 'f', 2), number)
                          : number;
}

}
