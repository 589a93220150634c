#include "Readers/LevelChoice.h"

#include "Readers/ChunkedVoxels.h"
#include "Readers/FileError.h"
#include "Readers/Memory.h"
#include "Readers/PagedPyramid.h"

#include <vtkDataArray.h>

#include <algorithm>
#include <iomanip>
#include <limits>
#include <sstream>

namespace varimarch
{

VoxelLayout LayoutOf(const PyramidForm& form, std::size_t level)
{
  return { form.levels[level].dimensions, form.scalarType, 1 };
}

double BytesOf(const VoxelLayout& layout)
{
  double bytes = double(vtkDataArray::GetDataTypeSize(layout.scalarType));
  for (const std::int64_t dimension : layout.dimensions)
  {
    bytes *= double(dimension);
  }
  return bytes;
}

double MostReadBytes(const ReadOptions& options)
{
  return 0.5 * std::min(FreeMemoryBytes(), double(MostMemoryBytes(options)));
}

std::string ObstacleToPaging(const PyramidForm& form, std::size_t level, const ReadOptions& options)
{
  const std::optional<VoxelType> type = VoxelTypeOf(form.scalarType);
  if (!type)
  {
    return "are not of 8 bits, 16 bits or type float";
  }
  if (options.areCopies)
  {
    return "are packed in an archive";
  }
  const auto& size = form.levels[level].dimensions;
  if (*std::max_element(size.begin(), size.end()) > std::numeric_limits<int>::max())
  {
    return "are more than 2147483647 along an axis";
  }
  const std::uint64_t mostBytes = MostMemoryBytes(options);
  const std::uint64_t ofBricks = BytesOfBricks(
    form.levels[level], *type, SideOfBricks(form.levels[level], *type, mostBytes / 2));
  if (ofBricks > mostBytes / 2)
  {
    return "have bricks for which " + ByteText(2.0 * double(ofBricks)) + " are needed";
  }
  return ChunkedVoxels::Obstacle(
    form.levels[level], std::size_t(vtkDataArray::GetDataTypeSize(form.scalarType)), mostBytes);
}

namespace
{

/// Voxels of the chunks that a level has [bytes].
double StoredBytes(const DecodedPyramid& pyramid, std::size_t level)
{
  const double all = BytesOf(LayoutOf(pyramid.Form(), level));
  const std::vector<std::uint8_t> areThere = pyramid.Stored(int(level)).areThere;
  const auto count = double(std::count(areThere.begin(), areThere.end(), 1));
  return areThere.empty() ? all : all * count / double(areThere.size());
}

/// The reason why a level is not opened unless somebody asks for it, as the rest of a sentence
/// about its voxels; empty if it is.
std::string Hindrance(const PyramidOrder& order,
  const std::shared_ptr<const DecodedPyramid>& pyramid, std::size_t level)
{
  constexpr double MostBytes = 100e9; // at 100 MB a second a quarter of an hour
  const PyramidForm& form = pyramid->Form();
  const double bytes = BytesOf(LayoutOf(form, level));
  if (bytes <= MostReadBytes(order.options))
  {
    return "";
  }
  const std::string obstacle = ObstacleToPaging(form, level, order.options);
  if (!obstacle.empty())
  {
    return "need more than half of the free memory and " + obstacle;
  }
  const double stored = bytes > MostBytes ? StoredBytes(*pyramid, level) : 0.0;
  if (stored <= MostBytes || PagedPyramid(order, pyramid, level).IsSummarized())
  {
    return "";
  }
  constexpr double BytesPerHour = 100e6 * 3600.0;
  std::ostringstream hours;
  hours << std::fixed << std::setprecision(1) << stored / BytesPerHour;
  return "have to be read once before they are drawn, " + ByteText(stored) + " in " + hours.str() +
    " hours at 100 MB a second; ask for level " + std::to_string(level) + " to have them";
}

}

LevelChoice LevelToRead(
  const PyramidOrder& order, const std::shared_ptr<const DecodedPyramid>& pyramid)
{
  const PyramidForm& form = pyramid->Form();
  const std::size_t count = form.levels.size();
  if (const std::optional<int> wanted = order.options.level)
  {
    if (*wanted < 0 || std::size_t(*wanted) >= count)
    {
      FailToRead(order.path, "a level from 0 to " + std::to_string(count - 1),
        "the wish for level " + std::to_string(*wanted));
    }
    return { std::size_t(*wanted), "" };
  }
  LevelChoice choice = { 0, "" };
  std::string ofFinest;
  while (choice.level + 1 < count)
  {
    const std::string hindrance = Hindrance(order, pyramid, choice.level);
    if (hindrance.empty())
    {
      break;
    }
    ofFinest = choice.level == 0 ? hindrance : ofFinest;
    ++choice.level;
  }
  if (choice.level > 0)
  {
    choice.reason = "Level " + std::to_string(choice.level) + ", " +
      Text(LayoutOf(form, choice.level)) + ", was read: the voxels of the finest, " +
      Text(LayoutOf(form, 0)) + ", " + ofFinest + ".";
  }
  return choice;
}

}
