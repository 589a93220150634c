#include "Core/Fields/LightLattice.h"

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

}

glm::ivec3 LightLattice::NodeCount(const glm::ivec3& voxelCount)
{
  return voxelCount / VoxelsPerNode;
}

// calloc takes zeros from the system page by page, when they are written.
LightLattice::LightLattice(const glm::ivec3& voxelCount)
  : bytes(BytesFor(NodeCount(voxelCount)))
  , nodes(this->bytes > 0 ? static_cast<std::uint8_t*>(std::calloc(this->bytes, 1)) : nullptr)
{
  if (this->bytes > 0 && !this->nodes)
  {
    throw std::runtime_error("Shadows: expected " + std::to_string(this->bytes) +
      " bytes of memory for a lattice of light, found none; close other programs, or switch "
      "shadows off");
  }
}

}
