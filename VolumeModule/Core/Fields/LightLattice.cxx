#include "Core/Fields/LightLattice.h"

#include <limits>
#include <stdexcept>
#include <string>

namespace varimarch
{

namespace
{

constexpr int FewestNodes = 2;

std::size_t BytesFor(const glm::ivec3& count)
{
  const bool hasCells = count.x >= FewestNodes && count.y >= FewestNodes && count.z >= FewestNodes;
  return hasCells ? std::size_t(count.x) * std::size_t(count.y) * std::size_t(count.z) : 0;
}

// Packets number nodes with 32 bits.
bool CanBeNumbered(const glm::ivec3& nodes)
{
  return BytesFor(nodes) <= std::size_t(std::numeric_limits<std::int32_t>::max());
}

}

// Beyond 2^34 voxels there are fewer nodes.
LatticeShape LightLattice::ShapeOfLight(const glm::ivec3& voxelCount)
{
  int voxelsPerNode = 2;
  while (!CanBeNumbered(voxelCount / voxelsPerNode))
  {
    voxelsPerNode *= 2;
  }
  return { voxelCount / voxelsPerNode, voxelsPerNode, 0 };
}

LatticeShape LightLattice::ShapeOfSky(const glm::ivec3& voxelCount)
{
  constexpr int Margin = SkyDistanceVoxels + 1;
  LatticeShape shape = { voxelCount + 2 * Margin, 1, Margin };
  while (!CanBeNumbered(shape.nodeCount))
  {
    shape.voxelsPerNode *= 2;
    shape.nodeCount = (voxelCount + 2 * Margin) / shape.voxelsPerNode + 1;
  }
  return shape;
}

// calloc takes zeros from the system page by page, when they are written.
LightLattice::LightLattice(const LatticeShape& shape)
  : shape(shape)
  , bytes(BytesFor(shape.nodeCount))
  , nodes(this->bytes > 0 ? static_cast<std::uint8_t*>(std::calloc(this->bytes, 1)) : nullptr)
{
  if (this->bytes > 0 && !this->nodes)
  {
    throw std::runtime_error("Light: expected " + std::to_string(this->bytes) +
      " bytes of memory for a lattice of light, found none; close other programs, or switch "
      "shadows and ambient occlusion off");
  }
}

}
