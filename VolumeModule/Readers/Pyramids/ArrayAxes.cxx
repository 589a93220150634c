#include "Readers/Pyramids/ArrayAxes.h"

#include "Readers/FileError.h"
#include "Readers/Parsing/HeaderText.h"
#include "Readers/Times.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace varimarch
{
namespace
{

constexpr std::size_t MostOmeAxes = 5;

/// The axis of the world that a name means; none for others.
std::optional<int> WorldOf(const std::string& name)
{
  static const std::map<std::string, int> worlds = { { "x", 0 }, { "col", 0 }, { "column", 0 },
    { "width", 0 }, { "y", 1 }, { "row", 1 }, { "height", 1 }, { "z", 2 }, { "plane", 2 },
    { "slice", 2 }, { "depth", 2 } };
  const auto world = worlds.find(name);
  return world == worlds.end() ? std::nullopt : std::optional(world->second);
}

ArrayAxis AxisNamed(const std::string& given)
{
  const std::string name = LowerCase(given);
  ArrayAxis axis;
  axis.name = given;
  axis.world = WorldOf(name);
  axis.isChannel = name == "c" || name == "channel" || name == "channels";
  axis.isTime = name == "t" || name == "time";
  return axis;
}

/// A direction of a patient: an axis of LPS, and -1 if it points the other way.
struct Direction
{
  int world;
  double sign;
};

/// The direction of an axis as RFC-4 of OME-Zarr states it; none for other texts, such as those for
/// animals.
std::optional<Direction> DirectionOf(const nlohmann::json& axis)
{
  static const std::map<std::string, Direction> directions = {
    { "right-to-left", { 0, 1.0 } },
    { "left-to-right", { 0, -1.0 } },
    { "anterior-to-posterior", { 1, 1.0 } },
    { "posterior-to-anterior", { 1, -1.0 } },
    { "inferior-to-superior", { 2, 1.0 } },
    { "superior-to-inferior", { 2, -1.0 } },
  };
  const nlohmann::json& orientation = ValueAt(axis, "orientation");
  const bool isText = orientation.is_string();
  const auto known =
    directions.find(LowerCase(TextIn(isText ? orientation : ValueAt(orientation, "value"))));
  return known == directions.end() ? std::nullopt : std::optional(known->second);
}

/// Turns axes of space into the directions that the file states, if it states three different ones.
/// @returns false if it does not
bool TakeDirections(const std::vector<nlohmann::json>& entries, ArrayAxes& axes)
{
  ArrayAxes turned = axes;
  bool isTaken[3] = {};
  for (std::size_t i = 0; i < axes.size(); ++i)
  {
    if (!axes[i].world)
    {
      continue;
    }
    const std::optional<Direction> direction = DirectionOf(entries[i]);
    if (!direction || isTaken[direction->world])
    {
      return false;
    }
    isTaken[direction->world] = true;
    turned[i].world = direction->world;
    turned[i].sign = direction->sign;
  }
  const bool areAll = isTaken[0] && isTaken[1] && isTaken[2];
  axes = areAll ? turned : axes;
  return areAll;
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

ArrayAxes AxesNamed(const std::string& path, const std::vector<std::string>& names)
{
  if (names.size() < 2)
  {
    FailToRead(path, "an array [z, y, x]", "one of " + std::to_string(names.size()) + " axes");
  }
  ArrayAxes axes;
  bool isTaken[3] = {};
  for (const std::string& name : names)
  {
    ArrayAxis axis = AxisNamed(name);
    if (axis.world && isTaken[*axis.world])
    {
      axis.world.reset();
    }
    else if (axis.world)
    {
      isTaken[*axis.world] = true;
    }
    axes.push_back(axis);
  }
  for (std::size_t i = axes.size(); i-- > 0;)
  {
    bool* const free = std::find(isTaken, isTaken + 3, false);
    const bool isOther = !axes[i].world && !axes[i].isChannel && !axes[i].isTime;
    if (isOther && free != isTaken + 3)
    {
      axes[i].world = int(free - isTaken);
      *free = true;
    }
    axes[i].name = axes[i].name.empty() ? "axis " + std::to_string(i) : axes[i].name;
  }
  return axes;
}

ArrayAxes OmeAxes(
  const std::string& path, const nlohmann::json& multiscale, std::vector<std::string>& warnings)
{
  ArrayAxes axes;
  const nlohmann::json& list = ValueAt(multiscale, "axes");
  // Versions 0.1 and 0.2 have no list; their images have these axes.
  const nlohmann::json usual = { "t", "c", "z", "y", "x" };
  const std::vector<nlohmann::json> entries = ListIn(list.is_null() ? usual : list);
  for (const nlohmann::json& entry : entries)
  {
    const bool isName = entry.is_string();
    ArrayAxis axis = AxisNamed(TextIn(isName ? entry : ValueAt(entry, "name")));
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
  const bool isNew = std::find(warnings.begin(), warnings.end(), UnknownSides) == warnings.end();
  if (!TakeDirections(entries, axes) && isNew)
  {
    warnings.push_back(UnknownSides);
  }
  return axes;
}

void ApplyTransforms(const std::string& path, const nlohmann::json& transforms, ArrayAxes& axes)
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

bool PlaceAxis(const std::vector<double>& coordinates, const std::string& unit, ArrayAxis& axis,
  std::vector<std::string>& warnings)
{
  const std::size_t count = coordinates.size();
  const double step =
    count > 1 ? (coordinates.back() - coordinates.front()) / double(count - 1) : 0.0;
  if (!std::isnormal(step))
  {
    return false;
  }
  constexpr double Tolerance = 0.01;
  double largest = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double even = coordinates.front() + double(i) * step;
    largest = std::max(largest, std::abs(coordinates[i] - even));
  }
  if (!(largest <= Tolerance * std::abs(step)))
  {
    warnings.push_back("The coordinates along " + Quoted(axis.name) +
      " are not evenly spaced; their mean distance was taken.");
  }
  axis.scale = step;
  axis.translation = coordinates.front();
  axis.mmPerUnit = axis.world ? MmPerUnitOrWarn(unit, warnings) : 1.0;
  axis.secondsPerUnit = axis.isTime ? SecondsPerUnit(unit) : 0.0;
  return true;
}

ArraySelection SelectionOf(const std::string& path, const ArrayAxes& axes,
  const std::vector<std::int64_t>& shape, bool isFortran, const ReadOptions& options)
{
  const std::size_t rank = shape.size();
  if (axes.size() != rank)
  {
    FailToRead(path, "an array of " + std::to_string(axes.size()) + " axes, as its metadata says",
      "one of " + std::to_string(rank));
  }
  constexpr std::size_t None = ArraySelection::NoAxis;
  ArraySelection selection = { { None, None, None }, std::vector<std::int64_t>(rank, 0) };
  bool isTaken[3] = {};
  std::size_t count = 0;
  std::int64_t channels = 1;
  std::int64_t times = 1;
  for (std::size_t i = 0; i < rank; ++i)
  {
    // The axis that runs fastest in a chunk comes first.
    const std::size_t place = isFortran ? i : rank - 1 - i;
    const ArrayAxis& axis = axes[place];
    if (axis.world && !isTaken[*axis.world])
    {
      isTaken[*axis.world] = true;
      selection.axes[count++] = place;
    }
    else if (axis.isChannel)
    {
      selection.start[place] = std::max(0, options.channel);
      channels = shape[place];
    }
    else if (axis.isTime)
    {
      selection.start[place] = options.time;
      times = shape[place];
    }
  }
  if (count < 2)
  {
    FailToRead(path, "at least two of the axes x, y and z", std::to_string(count) + " of them");
  }
  CheckPlace(path, "channel", std::max(0, options.channel), channels);
  CheckPlace(path, "time", options.time, times);
  return selection;
}

ImageGeometry GeometryOf(const ArrayAxes& axes, const ArraySelection& selection)
{
  ImageGeometry geometry;
  geometry.axesMm = glm::dmat3(0.0);
  bool isTaken[3] = {};
  for (int i = 0; i < 3; ++i)
  {
    if (selection.axes[i] != ArraySelection::NoAxis)
    {
      const ArrayAxis& axis = axes[selection.axes[i]];
      geometry.axesMm[i][*axis.world] = axis.sign * axis.scale * axis.mmPerUnit;
      geometry.originMm[*axis.world] = axis.sign * axis.translation * axis.mmPerUnit;
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

namespace
{

std::string PlaceLeftOut(const ArrayAxis& axis, std::int64_t count, int taken)
{
  return "The axis " + Quoted(axis.name) + " has " + std::to_string(count) +
    " places; only that of number " + std::to_string(taken) + ", counted from 0, was read.";
}

}

void DescribeAxes(
  const ArrayAxes& axes, const std::vector<std::int64_t>& shape, int channel, PyramidForm& form)
{
  constexpr std::int64_t MostChannels = 4;
  for (std::size_t i = 0; i < axes.size(); ++i)
  {
    const ArrayAxis& axis = axes[i];
    if (axis.isTime)
    {
      form.times = EvenTimes(
        shape[i], axis.translation * axis.secondsPerUnit, axis.scale * axis.secondsPerUnit);
    }
    else if (axis.isChannel && shape[i] > 1)
    {
      form.otherChannels = PlaceLeftOut(axis, shape[i], channel);
      for (std::int64_t c = 0; shape[i] <= MostChannels && c < shape[i]; ++c)
      {
        form.channels.push_back({ "Channel " + std::to_string(c + 1), {} });
      }
    }
    else if (!axis.world && !axis.isChannel && shape[i] > 1)
    {
      form.warnings.push_back(PlaceLeftOut(axis, shape[i], 0));
    }
  }
}

}
