#include "Readers/Dicom/FrameTimes.h"

#include "Readers/Dicom/Moment.h"
#include "Readers/NumberText.h"
#include "Readers/Times.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{
namespace
{

constexpr double SecondsPerMs = 1e-3;

/// The seconds of a time such as 134501.25, or of a date and time such as 20240131134501.25; NaN
/// for other texts.
double SecondsOfDicomTime(const std::string& text)
{
  constexpr std::size_t DateDigits = 8;
  constexpr std::size_t ClockDigits = 6;
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  const bool hasDate = digits == DateDigits + ClockDigits;
  if (!hasDate && digits != ClockDigits)
  {
    return NAN;
  }
  return hasDate ? *SecondsOfMoment(text.substr(0, DateDigits), text.substr(DateDigits))
                 : *SecondsOfMoment("19700101", text);
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
