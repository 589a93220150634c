#ifndef Varimarch_Core_Fields_LightLattice_h
#define Varimarch_Core_Fields_LightLattice_h

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>

namespace varimarch
{

/// The places of the nodes of a lattice: node n is at voxel voxelsPerNode * n - margin.
struct LatticeShape
{
  glm::ivec3 nodeCount; ///< at least 2 along each axis; else there are no cells of nodes
  int voxelsPerNode;
  int margin; ///< voxels by which the lattice begins before the volume, along each axis
};

/// The part of one light that reaches the nodes of a lattice in a volume, one byte each. Rays that
/// need a node fill it; since its light depends on nothing else, it does not matter which of them
/// does. Holds no memory for pages in which no node is filled.
class LightLattice
{
public:
  // A node's byte.
  static constexpr std::uint8_t Empty = 0; ///< not yet filled
  static constexpr std::uint8_t Dark = 1;  ///< no light
  static constexpr std::uint8_t Full = 255;

  /// The shape for a light that casts shadows: a node for every second voxel along each axis. It
  /// covers all voxels but the last, or the last two, and has no cells in a volume of fewer than
  /// four voxels along an axis. Takes at most an eighth of a byte for each voxel.
  static LatticeShape ShapeOfLight(const glm::ivec3& voxelCount);

  /// The distance of the place at which a surface sees what is around it, from the surface
  /// [voxels].
  static constexpr int SkyDistanceVoxels = 2;

  /// The shape for light from all around: a node for each voxel, and for all places at which
  /// surfaces at the faces of the volume see it.
  static LatticeShape ShapeOfSky(const glm::ivec3& voxelCount);

  /// An empty lattice.
  /// @throws std::runtime_error if there is no memory
  explicit LightLattice(const LatticeShape& shape);

  /// The nodes, x fastest; null without cells.
  std::uint8_t* Nodes() { return this->nodes.get(); }
  const LatticeShape& Shape() const { return this->shape; }
  std::size_t Bytes() const { return this->bytes; }

private:
  struct Free
  {
    void operator()(std::uint8_t* memory) const { std::free(memory); }
  };

  LatticeShape shape;
  std::size_t bytes;
  std::unique_ptr<std::uint8_t, Free> nodes;
};

}

#endif
