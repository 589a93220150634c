#include "Viewer/Model/TimeSpeed.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace varimarch
{

namespace
{

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

QString TimeText(const LoadedTimes& times, int time)
{
  const QLocale locale;
  const QString number = TimeTexts::tr("%1 of %2").arg(time + 1).arg(times.values.size());
  return times.areSeconds ? TimeTexts::tr("%1 s, %2")
                              .arg(locale.toString(times.values[std::size_t(time)], 'f', 2), number)
                          : number;
}

}
