#include "Readers/Pyramids/ZarrAxes.h"

#include "Readers/FileError.h"
#include "Readers/HeaderText.h"
#include "Readers/Times.h"

#include <cmath>

namespace varimarch
{
namespace
{

constexpr std::size_t MostOmeAxes = 5;

/// The axis of the world that a name means.
std::optional<int> WorldOf(const std::string& name)
{
  return name == "x" ? std::optional<int>(0)
    : name == "y"    ? std::optional<int>(1)
    : name == "z"    ? std::optional<int>(2)
                     : std::nullopt;
}

ZarrAxis AxisNamed(const std::string& name)
{
  ZarrAxis axis;
  axis.name = name;
  axis.world = WorldOf(LowerCase(name));
  axis.isChannel = name == "c" || name == "channel";
  axis.isTime = name == "t" || name == "time";
  return axis;
}

/// Numbers of a transform, one for each axis.
std::vector<double> NumbersOf(const std::string& path, const nlohmann::json& transform,
  const std::string& type, std::size_t count)
{
  const nlohmann::json& list = ValueAt(transform, type.c_str());
  const std::vector<double> numbers = NumbersIn(list);
  if (numbers.size() != count)
  {
    FailToRead(path, std::to_string(count) + " numbers as " + type, Quoted(list.dump()));
  }
  return numbers;
}

/// Fails unless an axis has a place.
void CheckPlace(
  const std::string& path, const std::string& axis, std::int64_t wanted, std::int64_t count)
{
  if (wanted < 0 || wanted >= count)
  {
    FailToRead(path, "a " + axis + " from 0 to " + std::to_string(count - 1),
      "the wish for " + axis + " " + std::to_string(wanted));
  }
}

}

ZarrAxes PlainZarrAxes(const std::string& path, std::size_t rank)
{
  if (rank < 2)
  {
    FailToRead(path, "an array [z, y, x]", "one of " + std::to_string(rank) + " axes");
  }
  ZarrAxes axes;
  for (std::size_t i = 0; i < rank; ++i)
  {
    const std::size_t fromEnd = rank - 1 - i;
    const char* const names[] = { "x", "y", "z" };
    axes.push_back(AxisNamed(fromEnd < 3 ? names[fromEnd] : "axis " + std::to_string(i)));
  }
  return axes;
}

ZarrAxes OmeAxes(
  const std::string& path, const nlohmann::json& multiscale, std::vector<std::string>& warnings)
{
  ZarrAxes axes;
  const nlohmann::json& list = ValueAt(multiscale, "axes");
  // Versions 0.1 and 0.2 have no list; their images have these axes.
  const nlohmann::json usual = { "t", "c", "z", "y", "x" };
  for (const nlohmann::json& entry : ListIn(list.is_null() ? usual : list))
  {
    const bool isName = entry.is_string();
    ZarrAxis axis = AxisNamed(TextIn(isName ? entry : ValueAt(entry, "name")));
    const std::string type = TextIn(ValueAt(entry, "type"));
    axis.isChannel = axis.isChannel || type == "channel";
    axis.isTime = axis.isTime || type == "time";
    const std::string unit = TextIn(ValueAt(entry, "unit"));
    if (axis.world)
    {
      axis.mmPerUnit = MmPerUnitOrWarn(unit, warnings);
    }
    axis.secondsPerUnit = axis.isTime ? SecondsPerUnit(unit) : 0.0;
    axes.push_back(axis);
  }
  if (axes.size() < 2 || axes.size() > MostOmeAxes)
  {
    FailToRead(path, "2 to 5 axes", Quoted(list.dump()));
  }
  return axes;
}

void ApplyTransforms(const std::string& path, const nlohmann::json& transforms, ZarrAxes& axes)
{
  for (const nlohmann::json& transform : ListIn(transforms))
  {
    const std::string type = TextIn(ValueAt(transform, "type"));
    if (type != "scale" && type != "translation" && type != "identity")
    {
      FailToRead(path, R"(the coordinateTransformations "scale" and "translation")", Quoted(type));
    }
    const std::vector<double> numbers =
      type == "identity" ? std::vector<double>() : NumbersOf(path, transform, type, axes.size());
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      const double number = numbers[i];
      axes[i].scale *= type == "scale" ? number : 1.0;
      axes[i].translation =
        type == "scale" ? axes[i].translation * number : axes[i].translation + number;
    }
  }
}

ZarrSelection SelectionOf(const std::string& path, const ZarrAxes& axes, const ZarrHeader& header,
  const ReadOptions& options)
{
  const std::size_t rank = header.shape.size();
  if (axes.size() != rank)
  {
    FailToRead(path, "an array of " + std::to_string(axes.size()) + " axes, as its metadata says",
      "one of " + std::to_string(rank));
  }
  constexpr std::size_t None = ZarrSelection::NoAxis;
  ZarrSelection selection = { { None, None, None }, std::vector<std::int64_t>(rank, 0) };
  bool isTaken[3] = {};
  std::size_t count = 0;
  std::int64_t channels = 1;
  std::int64_t times = 1;
  for (std::size_t i = 0; i < rank; ++i)
  {
    // The axis that runs fastest in a chunk comes first.
    const std::size_t place = header.isFortran ? i : rank - 1 - i;
    const ZarrAxis& axis = axes[place];
    if (axis.world && !isTaken[*axis.world])
    {
      isTaken[*axis.world] = true;
      selection.axes[count++] = place;
    }
    else if (axis.isChannel)
    {
      selection.start[place] = options.channel;
      channels = header.shape[place];
    }
    else if (axis.isTime)
    {
      selection.start[place] = options.time;
      times = header.shape[place];
    }
  }
  if (count < 2)
  {
    FailToRead(path, "at least two of the axes x, y and z", std::to_string(count) + " of them");
  }
  CheckPlace(path, "channel", options.channel, channels);
  CheckPlace(path, "time", options.time, times);
  return selection;
}

VolumeTimes TimesOf(const ZarrAxes& axes, const ZarrHeader& header)
{
  for (std::size_t i = 0; i < axes.size(); ++i)
  {
    if (axes[i].isTime)
    {
      const double seconds = axes[i].secondsPerUnit;
      return EvenTimes(header.shape[i], axes[i].translation * seconds, axes[i].scale * seconds);
    }
  }
  return {};
}

ImageGeometry GeometryOf(const ZarrAxes& axes, const ZarrSelection& selection)
{
  ImageGeometry geometry;
  geometry.axesMm = glm::dmat3(0.0);
  bool isTaken[3] = {};
  for (int i = 0; i < 3; ++i)
  {
    if (selection.axes[i] != ZarrSelection::NoAxis)
    {
      const ZarrAxis& axis = axes[selection.axes[i]];
      geometry.axesMm[i][*axis.world] = axis.scale * axis.mmPerUnit;
      geometry.originMm[*axis.world] = axis.translation * axis.mmPerUnit;
      isTaken[*axis.world] = true;
    }
  }
  // An image of one slice is a millimetre thick.
  for (int world = 0; world < 3; ++world)
  {
    geometry.axesMm[2][world] += isTaken[world] ? 0.0 : 1.0;
  }
  return geometry;
}

std::string PlaceLeftOut(const ZarrAxis& axis, std::int64_t count, int taken)
{
  return "The axis " + Quoted(axis.name) + " has " + std::to_string(count) +
    " places; only that of number " + std::to_string(taken) + ", counted from 0, was read.";
}

std::vector<std::string> LeftOut(const ZarrAxes& axes, const ZarrHeader& header)
{
  std::vector<std::string> sentences;
  for (std::size_t i = 0; i < axes.size(); ++i)
  {
    const bool isRead = axes[i].world || axes[i].isTime || axes[i].isChannel;
    if (!isRead && header.shape[i] > 1)
    {
      sentences.push_back(PlaceLeftOut(axes[i], header.shape[i], 0));
    }
  }
  return sentences;
}

}
