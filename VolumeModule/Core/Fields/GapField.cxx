#include "Core/Fields/GapField.h"

#include "Core/Fields/ChebyshevDistance.h"

#include <glm/common.hpp>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace varimarch
{

namespace
{

// Calls work(index, texel, distance) for each cell, on all cores.
template <class Work>
void ForEach(GapField& field, ChebyshevDistance& distance, Work work)
{
  const glm::ivec3 count = field.count;
  tbb::parallel_for(tbb::blocked_range<int>(0, count.y * count.z, 16),
    [&](const tbb::blocked_range<int>& rows)
    {
      for (int row = rows.begin(); row != rows.end(); ++row)
      {
        const glm::ivec3 first(0, row % count.y, row / count.y);
        std::uint8_t* const distances = distance.Row(first.y, first.z);
        for (int x = 0; x < count.x; ++x)
        {
          work(glm::ivec3(x, first.y, first.z), field.texels[std::size_t(row) * count.x + x],
            distances[x]);
        }
      }
    });
}

// @param presenceAt  presence of the cell at an index
template <class PresenceAt>
GapField BuildGapField(glm::ivec3 count, PresenceAt presenceAt)
{
  GapField field{ count, std::vector<std::uint8_t>(std::size_t(count.x) * count.y * count.z) };
  ChebyshevDistance distance(count);
  ForEach(field, distance,
    [&](glm::ivec3 index, std::uint8_t& texel, std::uint8_t& cellDistance)
    {
      const Presence presence = presenceAt(index);
      texel = presence == Presence::NoValue ? GapField::NoValue : GapField::LeftOut;
      cellDistance = presence == Presence::Drawn ? ChebyshevDistance::Farthest : 0;
    });
  distance.Measure();
  ForEach(field, distance,
    [&](glm::ivec3, std::uint8_t& texel, std::uint8_t cellDistance)
    { texel = cellDistance > 0 ? cellDistance : texel; });
  return field;
}

// The least presence in a box of voxels, both corners included, clipped to the grid.
Presence LeastPresence(const PresenceGrid& grid, glm::ivec3 lower, glm::ivec3 upper)
{
  const glm::ivec3 first = glm::max(lower, glm::ivec3(0));
  const glm::ivec3 last = glm::min(upper, grid.voxelCount - 1);
  Presence least = Presence::Drawn;
  for (int z = first.z; z <= last.z; ++z)
  {
    for (int y = first.y; y <= last.y; ++y)
    {
      const Presence* const row =
        &grid.voxels[(std::size_t(z) * grid.voxelCount.y + y) * grid.voxelCount.x];
      for (int x = first.x; x <= last.x; ++x)
      {
        least = std::min(least, row[x]);
      }
    }
  }
  return least;
}

}

GapField BuildGapFieldOfCells(const PresenceGrid& grid)
{
  const glm::ivec3 count = glm::max(grid.voxelCount - 1, glm::ivec3(1));
  return BuildGapField(count,
    [&](glm::ivec3 cell)
    {
      const std::size_t index = (std::size_t(cell.z) * count.y + cell.y) * count.x + cell.x;
      const Presence ofVoxels = LeastPresence(grid, cell, cell + 1);
      return grid.cells.empty() ? ofVoxels : std::min(ofVoxels, grid.cells[index]);
    });
}

GapField BuildGapFieldOfVoxels(const PresenceGrid& grid)
{
  return BuildGapField(grid.voxelCount,
    [&](glm::ivec3 voxel)
    {
      const int reach = grid.interpolated ? 1 : 0;
      const Presence around = LeastPresence(grid, voxel - reach, voxel + reach);
      return around == Presence::NoValue ? around : LeastPresence(grid, voxel, voxel);
    });
}

}
