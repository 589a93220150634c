#include "Readers/Dicom/Moment.h"

#include "Readers/NumberText.h"

#include <cstdlib>
#include <ctime>

namespace varimarch
{
namespace
{

/// The whole number at a place of a text; 0 if there is none.
int NumberAt(const std::string& text, std::size_t from, std::size_t count)
{
  return from < text.size() ? std::atoi(text.substr(from, count).c_str()) : 0;
}

}

std::optional<double> SecondsOfMoment(const std::string& date, const std::string& time)
{
  const std::string clock = time.substr(0, time.find_first_not_of("0123456789."));
  if (date.size() < 8 || clock.size() < 2)
  {
    return std::nullopt;
  }
  std::tm moment = {};
  moment.tm_year = NumberAt(date, 0, 4) - 1900;
  moment.tm_mon = NumberAt(date, 4, 2) - 1;
  moment.tm_mday = NumberAt(date, 6, 2);
  moment.tm_hour = NumberAt(clock, 0, 2);
  moment.tm_min = NumberAt(clock, 2, 2);
  const double seconds = clock.size() > 4 ? NumberIn(clock.substr(4)).value_or(0.0) : 0.0;
  return double(timegm(&moment)) + seconds;
}

std::optional<double> SecondsOfZone(const std::string& text)
{
  constexpr std::size_t Letters = 5;
  constexpr double SecondsPerMinute = 60.0;
  const std::string zone = text.size() < Letters ? "" : text.substr(text.size() - Letters);
  if (zone.empty() || zone.find_first_not_of("0123456789", 1) != std::string::npos ||
    (zone[0] != '+' && zone[0] != '-'))
  {
    return std::nullopt;
  }
  const double minutes = 60.0 * NumberAt(zone, 1, 2) + NumberAt(zone, 3, 2);
  return (zone[0] == '-' ? -1.0 : 1.0) * SecondsPerMinute * minutes;
}

}
