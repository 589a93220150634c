#include "Readers/Pyramids/Imaris.h"

#include "Readers/HeaderText.h"
#include "Readers/NumberText.h"
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

/// A number of an Imaris attribute, which is a text.
double NumberOfImaris(const Hdf5File& file, const std::string& object, const std::string& name)
{
  const std::string text = Trimmed(file.TextAttribute(object, name));
  return NumberFromText(file.Path(), "a number as " + name + " of " + object, text);
}

}

ImarisBox ImarisBoxOf(const Hdf5File& file, std::vector<std::string>& warnings)
{
  const std::string info = "/DataSetInfo/Image";
  const double mmPerUnit = MmPerUnitOrWarn(Trimmed(file.TextAttribute(info, "Unit")), warnings);
  ImarisBox box;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::string number = std::to_string(axis);
    box.lowest[axis] = NumberOfImaris(file, info, "ExtMin" + number) * mmPerUnit;
    box.highest[axis] = NumberOfImaris(file, info, "ExtMax" + number) * mmPerUnit;
  }
  return box;
}

std::array<std::int64_t, 3> ImarisDimensions(const Hdf5File& file, const std::string& group)
{
  std::array<std::int64_t, 3> dimensions;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::string name = std::string("ImageSize") + "XYZ"[axis];
    dimensions[axis] = WholeNumber(NumberOfImaris(file, group, name));
  }
  return dimensions;
}

ImageGeometry ImarisGeometry(const ImarisBox& box, const std::array<std::int64_t, 3>& dimensions)
{
  ImageGeometry geometry;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double stepMm =
      (box.highest[axis] - box.lowest[axis]) / double(dimensions[std::size_t(axis)]);
    geometry.axesMm[axis] = glm::dvec3(0.0);
    geometry.axesMm[axis][axis] = stepMm;
    geometry.originMm[axis] = box.lowest[axis] + 0.5 * stepMm;
  }
  return geometry;
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
