// Files of Zeiss' laser scanning microscopes (LSM): a page for each slice of each time, and between
// them thumbnails. The structure behind the private tag is that of "LSM File Format" of Zeiss.
#include "Readers/Images/TiffDescription.h"
#include "Readers/Images/TiffEntries.h"
#include "Readers/Times.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{
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
