#include "Resources/VolumeGaps.h"

#include "vtkDataArray.h"
#include "vtkSetGet.h"
#include "vtkUnsignedCharArray.h"

#include <glm/common.hpp>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>

namespace varimarch
{

namespace
{

// Calls work(index in the region, index in the volume) for all voxels or cells of a region.
template <class Work>
void ForEach(const VoxelRegion& region, glm::ivec3 wholeCount, Work work)
{
  tbb::parallel_for(tbb::blocked_range<int>(0, region.count.y * region.count.z),
    [&](const tbb::blocked_range<int>& rows)
    {
      for (int row = rows.begin(); row != rows.end(); ++row)
      {
        const glm::ivec3 first =
          region.first + glm::ivec3(0, row % region.count.y, row / region.count.y);
        const std::size_t whole =
          (std::size_t(first.z) * wholeCount.y + first.y) * wholeCount.x + first.x;
        for (int x = 0; x < region.count.x; ++x)
        {
          work(std::size_t(row) * region.count.x + x, whole + x);
        }
      }
    });
}

std::size_t CountOf(glm::ivec3 count)
{
  return std::size_t(count.x) * count.y * count.z;
}

template <class Scalar>
void MarkNotFinite(
  PresenceGrid& grid, const Scalar* scalars, int components, const ScalarRegion& region)
{
  ForEach(region.voxels, region.dimensions,
    [&](std::size_t index, std::size_t whole)
    {
      if (!std::isfinite(double(scalars[whole * components])))
      {
        grid.voxels[index] = Presence::NoValue;
      }
    });
}

std::vector<Presence> PresenceOf(
  vtkUnsignedCharArray* flags, const VoxelRegion& region, glm::ivec3 wholeCount)
{
  std::vector<Presence> presence(CountOf(region.count), Presence::Drawn);
  if (flags)
  {
    const unsigned char* const values = flags->GetPointer(0);
    ForEach(region, wholeCount,
      [&](std::size_t index, std::size_t whole)
      { presence[index] = values[whole] != 0 ? Presence::LeftOut : Presence::Drawn; });
  }
  return presence;
}

// Removes the cells that have a flagged point.
void TakeCellsAround(vtkUnsignedCharArray* pointFlags, glm::ivec3 pointCount,
  const ScalarRegion& region, std::vector<Presence>& cells)
{
  const unsigned char* const flags = pointFlags->GetPointer(0);
  const glm::ivec3 toOpposite = glm::min(pointCount - 1, glm::ivec3(1));
  const std::size_t rowLength = pointCount.x;
  const std::size_t sliceSize = rowLength * pointCount.y;
  ForEach(region.voxels, region.dimensions,
    [&](std::size_t index, std::size_t cell)
    {
      const std::size_t row = cell / region.dimensions.x;
      const std::size_t point = cell % region.dimensions.x + row % region.dimensions.y * rowLength +
        row / region.dimensions.y * sliceSize;
      for (int corner = 0; corner < 8; ++corner)
      {
        const glm::ivec3 step = glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2) * toOpposite;
        if (flags[point + step.x + step.y * rowLength + step.z * sliceSize] != 0)
        {
          cells[index] = Presence::LeftOut;
        }
      }
    });
}

}

GapField GapFieldOf(const ScalarRegion& region, const Blanking& blanking)
{
  const bool ofPoints = blanking.place == VoxelPlace::Points;
  PresenceGrid grid{ region.voxels.count,
    PresenceOf(ofPoints ? blanking.points : blanking.cells, region.voxels, region.dimensions), {},
    !blanking.nearest };
  if (!ofPoints && blanking.points)
  {
    TakeCellsAround(blanking.points, blanking.pointCount, region, grid.voxels);
  }
  if (ofPoints && blanking.cells)
  {
    const glm::ivec3 one(1);
    const VoxelRegion cells{ region.voxels.first, glm::max(region.voxels.count - 1, one) };
    grid.cells = PresenceOf(blanking.cells, cells, glm::max(region.dimensions - 1, one));
  }
  for (const VoxelComponent& component : region.components)
  {
    const void* const scalars = component.array->GetVoidPointer(component.index);
    const int components = component.array->GetNumberOfComponents();
    switch (component.array->GetDataType())
    {
      vtkTemplateMacro(
        MarkNotFinite(grid, static_cast<const VTK_TT*>(scalars), components, region));
    }
  }
  return blanking.IsOfVoxels() ? BuildGapFieldOfVoxels(grid) : BuildGapFieldOfCells(grid);
}

}
