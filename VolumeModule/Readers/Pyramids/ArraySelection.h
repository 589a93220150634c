#ifndef Varimarch_Readers_Pyramids_ArraySelection_h
#define Varimarch_Readers_Pyramids_ArraySelection_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace varimarch
{

/// The axes of an array in which a volume lies, and its place along the others.
struct ArraySelection
{
  static constexpr std::size_t NoAxis = std::size_t(-1);

  /// For each axis of the volume in memory, the fastest first, the axis of the array; NoAxis for
  /// one that the array does not have, with a single voxel.
  std::array<std::size_t, 3> axes;
  std::vector<std::int64_t> start; ///< the index along each axis of the array
};

}

#endif
