#ifndef Varimarch_Testing_MemorySource_h
#define Varimarch_Testing_MemorySource_h

#include "Core/Blocks/BrickSource.h"
#include "Core/Geometry/ScalarGrid.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace varimarch
{

/// Voxels in memory as if they were read piece by piece.
template <class Scalar>
class MemorySource : public BrickSource
{
public:
  /// @param slice  voxels along the axes of a slice
  MemorySource(VoxelType type, std::vector<Scalar> voxels, const glm::ivec2& slice)
    : type(type)
    , voxels(std::move(voxels))
    , slice(slice)
  {
    const glm::ivec3 size = this->Grid().Dimensions();
    this->levels = { { { size.x, size.y, size.z }, { 8, 8, 8 }, { 1.0, 1.0, 1.0 } } };
  }

  const std::vector<Level>& Levels() const override { return this->levels; }
  VoxelType Type() const override { return this->type; }
  void Read(int, const Box& box, void* to) const override
  {
    const ScalarGrid<Scalar> grid = this->Grid();
    auto* next = static_cast<Scalar*>(to);
    for (auto z = box.lower[2]; z < box.upper[2]; ++z)
    {
      for (auto y = box.lower[1]; y < box.upper[1]; ++y)
      {
        const Scalar* const row = grid.Row(int(y), int(z));
        next = std::copy(row + box.lower[0], row + box.upper[0], next);
      }
    }
  }

  ScalarGrid<Scalar> Grid() const
  {
    const int slices = int(this->voxels.size()) / (this->slice.x * this->slice.y);
    return { this->voxels.data(), { this->slice, slices } };
  }

private:
  VoxelType type;
  std::vector<Scalar> voxels;
  glm::ivec2 slice;
  std::vector<Level> levels;
};

}

#endif
