// Stacks of MetaMorph: a directory for the first plane, behind which the others lie. The tags are
// described in "MetaMorph Stack (STK) Image File Format" of Molecular Devices.
#include "Readers/FileError.h"
#include "Readers/HeaderText.h"
#include "Readers/Images/TiffDescription.h"
#include "Readers/Images/TiffEntries.h"
#include "Readers/Times.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace varimarch
{
namespace
{

constexpr int PropertyTag = 33628; ///< UIC1: pairs of a property and its value or file offset
constexpr int PlaneTag = 33629;    ///< UIC2: as many values as planes, of six numbers each

/// A number at an offset that is a pair of a numerator and a denominator; 0 if that is 0.
double FractionAt(const BinaryHeader& bytes, std::size_t offset)
{
  const double denominator = bytes.At<std::uint32_t>(offset + 4);
  return denominator > 0.0 ? bytes.At<std::uint32_t>(offset) / denominator : 0.0;
}

/// The text at a file offset, behind its length; its first 64 letters if it is longer.
std::string StoredText(const TiffEntries& entries, std::uint64_t offset)
{
  constexpr std::uint32_t MostLetters = 64;
  const auto length = entries.BytesAt(offset, 4).At<std::uint32_t>(0);
  return entries.BytesAt(offset + 4, MostLetters).Bytes().substr(0, std::min(MostLetters, length));
}

/// The lengths that the file states.
struct Calibration
{
  double mmPerUnit = 0.0;           ///< 0 if it is not calibrated
  std::array<double, 2> pixel = {}; ///< in the unit
};

Calibration CalibrationOf(const TiffEntries& entries, std::vector<std::string>& warnings)
{
  constexpr std::size_t MostProperties = 4096;
  constexpr int LongType = 4;
  Calibration calibration;
  const std::optional<TiffEntry> list = entries.At(PropertyTag);
  if (!list || list->type != LongType)
  {
    return calibration;
  }
  const auto count = std::size_t(std::min<std::uint64_t>(list->count, MostProperties));
  const BinaryHeader pairs = entries.BytesAt(list->value, 8 * count);
  bool isCalibrated = false;
  std::string unit;
  for (std::size_t at = 0; at < 8 * count; at += 8)
  {
    const auto value = pairs.At<std::uint32_t>(at + 4);
    switch (pairs.At<std::uint32_t>(at))
    {
      case 3:
        isCalibrated = value != 0;
        break;
      case 4:
        calibration.pixel[0] = FractionAt(entries.BytesAt(value, 8), 0);
        break;
      case 5:
        calibration.pixel[1] = FractionAt(entries.BytesAt(value, 8), 0);
        break;
      case 6:
        unit = StoredText(entries, value);
        break;
      default:
        break;
    }
  }
  unit = Trimmed(unit.substr(0, unit.find('\0')));
  const bool isLength =
    isCalibrated && !unit.empty() && LowerCase(unit) != "pixel" && LowerCase(unit) != "pixels";
  calibration.mmPerUnit = isLength ? MmPerUnitOrWarn(unit, warnings) : 0.0;
  return calibration;
}

/// The places and moments of the planes.
struct StkPlanes
{
  std::vector<double> heights; ///< in the unit of the calibration
  std::vector<double> seconds; ///< moments, counted in days of the Julian calendar
};

/// The planes of which the value of UIC2 at a file offset tells.
StkPlanes PlanesAt(const TiffEntries& entries, std::uint64_t offset, std::size_t count)
{
  constexpr std::size_t PlaneBytes = 24;
  constexpr double SecondsPerDay = 86400.0;
  const BinaryHeader bytes = entries.BytesAt(offset, PlaneBytes * count);
  StkPlanes planes;
  for (std::size_t at = 0; at < PlaneBytes * count; at += PlaneBytes)
  {
    planes.heights.push_back(FractionAt(bytes, at));
    planes.seconds.push_back(
      SecondsPerDay * bytes.At<std::uint32_t>(at + 8) + 1e-3 * bytes.At<std::uint32_t>(at + 12));
  }
  return planes;
}

/// Distance of planes by their heights or, as some programs write, by the distance of each from the
/// one before; 0 if the file states neither.
double DistanceOf(const std::vector<double>& heights)
{
  const double difference = std::abs(heights.back() - heights.front());
  return difference > 0.0 ? difference / double(heights.size() - 1) : heights.front();
}

/// True for planes without heights of which each was taken after the one before.
bool AreTimes(const StkPlanes& planes)
{
  const std::vector<double>& seconds = planes.seconds;
  return seconds.size() > 1 && DistanceOf(planes.heights) == 0.0 &&
    std::adjacent_find(seconds.begin(), seconds.end(), std::greater_equal<double>()) ==
    seconds.end();
}

}

std::optional<TiffStack> StkStack(TiffFile& file, std::int64_t time)
{
  const TiffEntries entries(file);
  const std::optional<TiffEntry> list = entries.At(PlaneTag);
  if (!list || list->count < 1 || file.Pages().size() != 1)
  {
    return std::nullopt;
  }
  constexpr std::uint64_t MostPlanes = 1000000;
  if (list->count > MostPlanes)
  {
    FailToRead(file.Path(), "at most 1000000 planes (UIC2)", std::to_string(list->count));
  }
  const auto count = std::size_t(list->count);
  StkPlanes planes = PlanesAt(entries, list->value, count);
  if (count > 1)
  {
    file.AddPagesBehindFirst(count - 1);
  }
  TiffStack stack;
  const Calibration calibration = CalibrationOf(entries, stack.warnings);
  stack.spacingMm = { calibration.pixel[0] * calibration.mmPerUnit,
    calibration.pixel[1] * calibration.mmPerUnit,
    DistanceOf(planes.heights) * calibration.mmPerUnit };
  if (!AreTimes(planes))
  {
    for (std::size_t page = 0; page < count; ++page)
    {
      stack.planes.push_back({ file.Path(), page });
    }
    return stack;
  }
  const double first = planes.seconds.front();
  std::for_each(
    planes.seconds.begin(), planes.seconds.end(), [first](double& moment) { moment -= first; });
  stack.times = StatedTimes(planes.seconds);
  stack.planes.push_back(
    { file.Path(), std::size_t(std::clamp<std::int64_t>(time, 0, std::int64_t(count) - 1)) });
  return stack;
}

}
