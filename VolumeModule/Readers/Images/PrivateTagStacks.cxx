// Stacks that private tags describe. Stacks of MetaMorph (STK) have a directory for the first
// plane, behind which the others lie; see "MetaMorph Stack (STK) Image File Format" of Molecular
// Devices. Files of Zeiss' laser scanning microscopes (LSM) have a page for each slice of each
// time, and between them thumbnails; see "LSM File Format" of Zeiss.
#include "Readers/FileError.h"
#include "Readers/Images/TiffDescription.h"
#include "Readers/Images/TiffFile.h"
#include "Readers/Packed/ByteStream.h"
#include "Readers/Parsing/BinaryHeader.h"
#include "Readers/Parsing/FileContent.h"
#include "Readers/Parsing/HeaderText.h"
#include "Readers/Times.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace varimarch
{
namespace
{

/// An entry of a directory, of which libtiff tells nothing for the private tags of programs.
struct TiffEntry
{
  int type;            ///< the number of a type, such as 4 for LONG
  std::uint64_t count; ///< number of values
  std::uint64_t value; ///< the value itself, or the file offset of several
};

/// The entries of the first directory of a TIFF file, as they are stored.
class TiffEntries
{
public:
  explicit TiffEntries(const TiffFile& file);

  /// The entry of a tag; nothing if the directory has none.
  std::optional<TiffEntry> At(int tag) const;

  /// Bytes of the file from an offset on; less at its end.
  BinaryHeader BytesAt(std::uint64_t offset, std::size_t count) const;

private:
  std::string path;
  bool isBigEndian;
  std::map<int, TiffEntry> entries;
};

TiffEntries::TiffEntries(const TiffFile& file)
  : path(file.Path())
  , isBigEndian(FirstBytes(file.Path()).compare(0, 1, "M") == 0)
{
  const std::uint64_t directory = file.Pages().front().directory;
  // A header of BigTIFF has the version 43.
  const bool isBig = this->BytesAt(0, 4).At<unsigned short>(2) == 43;
  const BinaryHeader begin = this->BytesAt(directory, 8);
  constexpr std::uint64_t MostEntries = 4096;
  const std::uint64_t count =
    std::min(MostEntries, isBig ? begin.At<std::uint64_t>(0) : begin.At<unsigned short>(0));
  const std::size_t entryBytes = isBig ? 20 : 12;
  const BinaryHeader bytes =
    this->BytesAt(directory + (isBig ? 8 : 2), std::size_t(count) * entryBytes);
  for (std::size_t at = 0; at + entryBytes <= bytes.Bytes().size(); at += entryBytes)
  {
    const TiffEntry entry = isBig
      ? TiffEntry{ bytes.At<unsigned short>(at + 2), bytes.At<std::uint64_t>(at + 4),
          bytes.At<std::uint64_t>(at + 12) }
      : TiffEntry{ bytes.At<unsigned short>(at + 2), bytes.At<std::uint32_t>(at + 4),
          bytes.At<std::uint32_t>(at + 8) };
    this->entries.emplace(bytes.At<unsigned short>(at), entry);
  }
}

std::optional<TiffEntry> TiffEntries::At(int tag) const
{
  const auto entry = this->entries.find(tag);
  return entry == this->entries.end() ? std::nullopt : std::optional(entry->second);
}

BinaryHeader TiffEntries::BytesAt(std::uint64_t offset, std::size_t count) const
{
  std::string bytes(count, '\0');
  bytes.resize(OpenStream(this->path, Compression::None, offset)->Read(bytes.data(), bytes.size()));
  return { std::move(bytes), this->isBigEndian };
}

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

namespace
{

/// The numbers of the pages that are no thumbnails.
std::vector<std::size_t> PagesOfSlices(const TiffFile& file)
{
  std::vector<std::size_t> pages;
  for (std::size_t page = 0; page < file.Pages().size(); ++page)
  {
    if (!file.Pages()[page].isReduced)
    {
      pages.push_back(page);
    }
  }
  return pages;
}

/// A distance of voxels [mm], which is stored in metres; 0 if it is not known.
double SpacingMmAt(const BinaryHeader& fields, std::size_t offset)
{
  constexpr double MmPerMetre = 1000.0;
  const double metres = fields.At<double>(offset);
  return std::isfinite(metres) && metres > 0.0 ? metres * MmPerMetre : 0.0;
}

}

std::optional<TiffStack> LsmStack(const TiffFile& file, std::int64_t time)
{
  constexpr int InfoTag = 34412;
  constexpr std::size_t InfoBytes = 120;
  const TiffEntries entries(file);
  const std::optional<TiffEntry> info = entries.At(InfoTag);
  if (!info || info->count < InfoBytes)
  {
    return std::nullopt;
  }
  const BinaryHeader fields = entries.BytesAt(info->value, InfoBytes);
  const auto sliceCount = std::size_t(std::max(1, fields.At<int>(16)));
  const std::int64_t timeCount = std::max(1, fields.At<int>(24));
  const std::vector<std::size_t> pages = PagesOfSlices(file);
  // A scan that was stopped has fewer pages than were planned.
  const std::int64_t complete =
    std::min(timeCount, std::int64_t(pages.size() / std::max<std::size_t>(1, sliceCount)));
  if (complete < 1)
  {
    return std::nullopt;
  }
  TiffStack stack;
  stack.spacingMm = { SpacingMmAt(fields, 40), SpacingMmAt(fields, 48), SpacingMmAt(fields, 56) };
  stack.times = EvenTimes(complete, 0.0, fields.At<double>(112));
  const auto first = std::size_t(std::clamp<std::int64_t>(time, 0, complete - 1)) * sliceCount;
  for (std::size_t slice = first; slice < first + sliceCount; ++slice)
  {
    stack.planes.push_back({ file.Path(), pages[slice] });
  }
  const std::size_t used = sliceCount * std::size_t(complete);
  if (used < pages.size())
  {
    stack.warnings.push_back("The last " + std::to_string(pages.size() - used) + " of " +
      std::to_string(pages.size()) + " pages are not among the slices and times that the file " +
      "states; they were left out.");
  }
  return stack;
}

}
