#include "Readers/Pyramids/Imaris.h"

#include "Readers/HeaderText.h"
#include "Readers/Pyramids/Hdf5File.h"
#include "Readers/Times.h"

#include <glm/common.hpp>

#include <algorithm>
#include <ctime>
#include <iomanip>
#include <locale>
#include <optional>
#include <sstream>
#include <string>

namespace varimarch
{
namespace
{

/// Seconds of a moment such as "2023-05-17 09:30:00.250" since one that is always the same; none
/// for other texts.
std::optional<double> SecondsOfMoment(const std::string& text)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  std::tm moment = {};
  if (!(stream >> std::get_time(&moment, "%Y-%m-%d %H:%M:%S")))
  {
    return std::nullopt;
  }
  double fraction = 0.0;
  const bool isWhole = !(stream >> fraction);
  return double(timegm(&moment)) + (isWhole ? 0.0 : fraction);
}

}

VolumeTimes ImarisTimes(const Hdf5File& file, std::size_t count)
{
  std::vector<double> seconds;
  for (std::size_t i = 1; i <= count; ++i)
  {
    const std::optional<double> moment = SecondsOfMoment(
      Trimmed(file.TextAttribute("/DataSetInfo/TimeInfo", "TimePoint" + std::to_string(i))));
    if (!moment)
    {
      return NumberedTimes(std::int64_t(count));
    }
    seconds.push_back(*moment);
  }
  const double first = seconds.empty() ? 0.0 : seconds.front();
  std::transform(seconds.begin(), seconds.end(), seconds.begin(),
    [first](double moment) { return moment - first; });
  return StatedTimes(seconds);
}

std::vector<VolumeChannel> ImarisChannels(const Hdf5File& file, std::size_t count)
{
  std::vector<VolumeChannel> channels;
  for (std::size_t i = 0; count > 1 && count <= 4 && i < count; ++i)
  {
    const std::string group = "/DataSetInfo/Channel " + std::to_string(i);
    const std::string name = Trimmed(file.TextAttribute(group, "Name"));
    VolumeChannel channel = { name.empty() ? "Channel " + std::to_string(i + 1) : name, {} };
    std::istringstream color(file.TextAttribute(group, "Color"));
    color.imbue(std::locale::classic());
    glm::dvec3 rgb;
    if (color >> rgb.r >> rgb.g >> rgb.b)
    {
      channel.rgb = glm::clamp(rgb, 0.0, 1.0);
    }
    channels.push_back(channel);
  }
  return channels;
}

}
