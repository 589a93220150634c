#ifndef Varimarch_Core_Fields_LightLattice_h
#define Varimarch_Core_Fields_LightLattice_h

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>

namespace varimarch
{

/// The part of one light that reaches the nodes of a lattice in a volume, one byte each. Rays that
/// need a node fill it; since its light depends on nothing else, it does not matter which of them
/// does. Holds no memory for pages in which no node is filled.
class LightLattice
{
public:
  static constexpr int VoxelsPerNode = 2; ///< voxels between two nodes, along each axis

  // A node's byte.
  static constexpr std::uint8_t Empty = 0; ///< not yet filled
  static constexpr std::uint8_t Dark = 1;  ///< no light
  static constexpr std::uint8_t Full = 255;

  /// An empty lattice. It covers all voxels but the last along each axis, or the last two.
  /// @throws std::runtime_error if there is no memory
  explicit LightLattice(const glm::ivec3& voxelCount);

  /// The nodes, x fastest; node n is at voxel VoxelsPerNode * n. Null for a volume of fewer than
  /// four voxels along an axis, which has no cells of nodes.
  std::uint8_t* Nodes() { return this->nodes.get(); }
  static glm::ivec3 NodeCount(const glm::ivec3& voxelCount);
  std::size_t Bytes() const { return this->bytes; } ///< At most an eighth of a byte for each voxel.

private:
  struct Free
  {
    void operator()(std::uint8_t* memory) const { std::free(memory); }
  };

  std::size_t bytes;
  std::unique_ptr<std::uint8_t, Free> nodes;
};

}

#endif
