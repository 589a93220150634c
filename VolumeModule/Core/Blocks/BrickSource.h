#ifndef Varimarch_Core_Blocks_BrickSource_h
#define Varimarch_Core_Blocks_BrickSource_h

#include "Core/Geometry/VoxelType.h"

#include <array>
#include <cstdint>
#include <vector>

namespace varimarch
{

/// A volume of one component that may be larger than memory, of which any box of voxels can be
/// read. It may have coarser levels too. It holds no voxels for longer than a call, and knows
/// nothing of rays: its users decide what is kept.
class BrickSource
{
public:
  /// The volume at one resolution. Level 0 is the finest.
  struct Level
  {
    std::array<std::int64_t, 3> dimensions; ///< voxels along each axis, x fastest
    std::array<std::int64_t, 3> chunk;      ///< voxels of the boxes that are read at the best speed
    std::array<double, 3> scale;            ///< voxels of level 0 per voxel along each axis
  };

  /// Voxels from `lower` to before `upper`, along each axis.
  struct Box
  {
    std::array<std::int64_t, 3> lower;
    std::array<std::int64_t, 3> upper;
  };

  virtual ~BrickSource() = default;

  /// At least one level, from fine to coarse.
  virtual const std::vector<Level>& Levels() const = 0;

  virtual VoxelType Type() const = 0;

  /// Reads the voxels of a box, which is inside the level, densely packed with x fastest. May be
  /// called from several threads at the same time.
  /// @throws std::runtime_error with one sentence if the voxels cannot be read
  virtual void Read(int level, const Box& box, void* voxels) const = 0;

  /// The part of a box of level 0 that has to be read: all voxels around it have the value Fill(),
  /// because the store has nothing there. Equal corners if nothing has to be read.
  virtual Box Occupied(const Box& box) const { return box; }

  /// The value of voxels that are not stored.
  virtual double Fill() const { return 0.0; }
};

}

#endif
