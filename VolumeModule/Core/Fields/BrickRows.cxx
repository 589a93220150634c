#include "Core/Fields/BrickRows.h"

#include "Core/Fields/BrickRanges.h"
#include "Core/Geometry/ScalarGrid.h"

#include <glm/common.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <mutex>

namespace varimarch
{
namespace
{

using RowSet = std::vector<std::uint16_t>;

/// The voxels of a mask that a brick touches, from the one at its first corner to the one at its
/// last.
VoxelRegion VoxelsOfBrick(glm::ivec3 brick, glm::ivec3 maskSize, glm::ivec3 voxelCount)
{
  const glm::dvec3 maskPerVoxel = glm::dvec3(maskSize) / glm::dvec3(voxelCount);
  const glm::dvec3 begin(BrickRanges::CellsPerSide * brick);
  const auto voxelAt = [&](glm::dvec3 position)
  {
    return glm::clamp(
      glm::ivec3(glm::floor((position + 0.5) * maskPerVoxel)), glm::ivec3(0), maskSize - 1);
  };
  const glm::ivec3 first = voxelAt(begin);
  return { first, voxelAt(begin + double(BrickRanges::CellsPerSide)) - first + 1 };
}

/// @param set  receives the rows of a region, ascending
void TakeRows(const ScalarGrid<std::uint16_t>& mask, const VoxelRegion& region, RowSet& set)
{
  set.assign(1, mask.Voxel(region.first));
  for (int z = region.first.z; z < region.first.z + region.count.z; ++z)
  {
    for (int y = region.first.y; y < region.first.y + region.count.y; ++y)
    {
      const std::uint16_t* const row = mask.Row(y, z);
      for (int x = region.first.x; x < region.first.x + region.count.x; ++x)
      {
        if (row[x] != set.back())
        {
          set.push_back(row[x]);
        }
      }
    }
  }
  std::sort(set.begin(), set.end());
  set.erase(std::unique(set.begin(), set.end()), set.end());
}

/// Numbers different sets as they come.
class RowSetNumbers
{
public:
  std::uint32_t NumberOf(const RowSet& set)
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    return this->numbers.emplace(set, std::uint32_t(this->numbers.size())).first->second;
  }

  std::vector<RowSet> Sets() const
  {
    std::vector<RowSet> sets(this->numbers.size());
    for (const auto& [set, number] : this->numbers)
    {
      sets[number] = set;
    }
    return sets;
  }

private:
  std::mutex mutex;
  std::map<RowSet, std::uint32_t> numbers;
};

}

BrickRows::BrickRows(
  const std::vector<std::uint16_t>& rows, glm::ivec3 maskSize, glm::ivec3 voxelCount)
{
  constexpr int Side = BrickRanges::CellsPerSide;
  const ScalarGrid<std::uint16_t> mask(rows.data(), maskSize);
  const glm::ivec3 cellCount = glm::max(voxelCount - 1, glm::ivec3(1));
  const glm::ivec3 count = (cellCount + Side - 1) / Side;
  this->setOfBrick.resize(std::size_t(count.x) * count.y * count.z);
  RowSetNumbers numbers;
  tbb::parallel_for(tbb::blocked_range<int>(0, count.y * count.z),
    [&](const tbb::blocked_range<int>& brickRows)
    {
      RowSet set;
      RowSet last;
      std::uint32_t number = 0;
      for (int brickRow = brickRows.begin(); brickRow != brickRows.end(); ++brickRow)
      {
        for (int x = 0; x < count.x; ++x)
        {
          const glm::ivec3 brick(x, brickRow % count.y, brickRow / count.y);
          TakeRows(mask, VoxelsOfBrick(brick, maskSize, voxelCount), set);
          if (set != last) // neighbours are mostly alike
          {
            number = numbers.NumberOf(set);
            last = set;
          }
          this->setOfBrick[std::size_t(brickRow) * count.x + x] = number;
        }
      }
    });
  this->sets = numbers.Sets();
}

namespace
{

constexpr std::uint16_t Farthest = 255;

/// The voxels of a box, visited in index order or in reverse.
class Neighbours
{
public:
  explicit Neighbours(glm::ivec3 size)
    : size(size)
  {
  }

  /// Calls visit(index) for the neighbours that precede a voxel in index order (direction 1) or in
  /// reverse order (-1).
  template <class Visit>
  void Before(glm::ivec3 voxel, int direction, Visit visit) const
  {
    for (int z = -1; z <= 0; ++z)
    {
      for (int y = -1; y <= (z < 0 ? 1 : 0); ++y)
      {
        for (int x = -1; x <= (z < 0 || y < 0 ? 1 : -1); ++x)
        {
          const glm::ivec3 beside = voxel + direction * glm::ivec3(x, y, z);
          if (beside == glm::clamp(beside, glm::ivec3(0), this->size - 1))
          {
            visit(this->Index(beside));
          }
        }
      }
    }
  }

  std::size_t Index(glm::ivec3 voxel) const
  {
    return voxel.x + std::size_t(this->size.x) * (voxel.y + std::size_t(this->size.y) * voxel.z);
  }

private:
  glm::ivec3 size;
};

}

// The path to a voxel with another label leads over a voxel at which the label changes. The
// distance is therefore one more than that of the nearest such voxel, by the two passes of
// Rosenfeld and Pfaltz (Pattern Recognition 1968) over the 26 neighbours.
std::vector<std::uint16_t> LabelReach(const std::vector<std::uint16_t>& labels, glm::ivec3 size)
{
  const Neighbours neighbours(size);
  std::vector<std::uint16_t> reach(labels.size(), Farthest);
  const auto pass = [&](int direction)
  {
    const glm::ivec3 last = size - 1;
    for (int k = 0; k < size.z; ++k)
    {
      for (int j = 0; j < size.y; ++j)
      {
        for (int i = 0; i < size.x; ++i)
        {
          const glm::ivec3 forward(i, j, k);
          const glm::ivec3 voxel = direction > 0 ? forward : last - forward;
          const std::size_t here = neighbours.Index(voxel);
          neighbours.Before(voxel, direction,
            [&](std::size_t beside)
            {
              const bool changes = labels[beside] != labels[here];
              const int least = changes ? 1 : reach[beside] + 1;
              reach[here] = std::uint16_t(std::min(int(reach[here]), least));
            });
        }
      }
    }
  };
  pass(1);
  pass(-1);
  return reach;
}

}
