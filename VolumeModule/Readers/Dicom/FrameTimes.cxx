#include "Readers/Dicom/FrameTimes.h"

#include "Readers/NumberText.h"
#include "Readers/Times.h"

#include <cmath>
#include <ctime>

namespace varimarch
{
namespace
{

constexpr double SecondsPerMs = 1e-3;

/// A part of a text of digits as a number; 0 for anything else.
int Digits(const std::string& text, std::size_t begin, std::size_t count)
{
  return begin + count <= text.size() ? int(NumberIn(text.substr(begin, count)).value_or(0.0)) : 0;
}

/// The seconds of a time such as 134501.25, or of a date and time such as 20240131134501.25; NaN
/// for other texts (PS3.5 table 6.2-1).
double SecondsOfDicomTime(const std::string& text)
{
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  const bool hasDate = digits == 14;
  if (!hasDate && digits != 6)
  {
    return NAN;
  }
  const std::string fraction = "0" +
    text.substr(digits, std::min(text.find_first_not_of(".0123456789"), text.size()) - digits);
  std::tm moment = {};
  moment.tm_year = hasDate ? Digits(text, 0, 4) - 1900 : 70;
  moment.tm_mon = hasDate ? Digits(text, 4, 2) - 1 : 0;
  moment.tm_mday = hasDate ? Digits(text, 6, 2) : 1;
  moment.tm_hour = Digits(text, digits - 6, 2);
  moment.tm_min = Digits(text, digits - 4, 2);
  moment.tm_sec = Digits(text, digits - 2, 2);
  return double(timegm(&moment)) + NumberIn(fraction).value_or(0.0);
}

/// Time after the R wave [s]. A text that begins with a blank is the number of a slot of nuclear
/// medicine.
double TriggerSeconds(const DicomFrame& frame)
{
  const std::string& text = frame.differences[std::size_t(DicomDifference::TriggerTime)];
  const bool isSlot = !text.empty() && text.front() == ' ';
  return isSlot ? NAN : SecondsPerMs * NumberIn(text).value_or(NAN);
}

double ClockSeconds(const DicomFrame& frame, DicomDifference difference)
{
  return SecondsOfDicomTime(frame.differences[std::size_t(difference)]);
}

double StatedSeconds(const DicomFrame& frame)
{
  return frame.timeSeconds.value_or(NAN);
}

double AcquisitionSeconds(const DicomFrame& frame)
{
  return ClockSeconds(frame, DicomDifference::AcquisitionTime);
}

double ContentSeconds(const DicomFrame& frame)
{
  return ClockSeconds(frame, DicomDifference::ContentTime);
}

}

VolumeTimes TimesOf(const std::vector<const DicomFrame*>& frames)
{
  for (const auto secondsOf : { StatedSeconds, TriggerSeconds, AcquisitionSeconds, ContentSeconds })
  {
    const bool isClock = secondsOf == AcquisitionSeconds || secondsOf == ContentSeconds;
    const double start = isClock ? secondsOf(*frames.front()) : 0.0;
    std::vector<double> seconds;
    for (const DicomFrame* frame : frames)
    {
      seconds.push_back(secondsOf(*frame) - start);
    }
    const VolumeTimes times = StatedTimes(seconds);
    if (times.areSeconds)
    {
      return times;
    }
  }
  return NumberedTimes(std::int64_t(frames.size()));
}

}
