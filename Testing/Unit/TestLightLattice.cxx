// The memory of a lattice of light.

#include "Core/Fields/LightLattice.h"

#include <gtest/gtest.h>

using namespace varimarch;

TEST(LightLattice, TakesAtMostAnEighthOfAByteForEachVoxel)
{
  for (const glm::ivec3 count : { glm::ivec3(4), glm::ivec3(5, 6, 7), glm::ivec3(100, 33, 64) })
  {
    const LightLattice lattice(count);
    EXPECT_LE(8 * lattice.Bytes(), std::size_t(count.x) * count.y * count.z);
    EXPECT_GT(lattice.Bytes(), 0u);
  }
}

TEST(LightLattice, IsEmptyAtFirst)
{
  LightLattice lattice(glm::ivec3(20, 30, 40));
  const std::uint8_t* const nodes = lattice.Nodes();
  for (std::size_t node = 0; node < lattice.Bytes(); ++node)
  {
    ASSERT_EQ(nodes[node], LightLattice::Empty) << node;
  }
}

TEST(LightLattice, OfAThinVolumeHasNoNodes)
{
  LightLattice lattice(glm::ivec3(100, 100, 3));
  EXPECT_EQ(lattice.Nodes(), nullptr);
  EXPECT_EQ(lattice.Bytes(), 0u);
}
