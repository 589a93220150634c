// The memory of a lattice of light.

#include "Core/Fields/LightLattice.h"

#include <gtest/gtest.h>

using namespace varimarch;

TEST(LightLattice, OfALightTakesAtMostAnEighthOfAByteForEachVoxel)
{
  for (const glm::ivec3 count : { glm::ivec3(4), glm::ivec3(5, 6, 7), glm::ivec3(100, 33, 64) })
  {
    const LightLattice lattice(LightLattice::ShapeOfLight(count));
    EXPECT_LE(8 * lattice.Bytes(), std::size_t(count.x) * count.y * count.z);
    EXPECT_GT(lattice.Bytes(), 0u);
  }
}

TEST(LightLattice, HasNodesThat32BitsCanNumberInAnyVolume)
{
  const glm::ivec3 large(4096, 4096, 2048); // 2^35 voxels
  for (const LatticeShape& shape :
    { LightLattice::ShapeOfLight(large), LightLattice::ShapeOfSky(large) })
  {
    const double nodes = double(shape.nodeCount.x) * shape.nodeCount.y * shape.nodeCount.z;
    EXPECT_LT(nodes, 2147483648.0);
    EXPECT_EQ(shape.voxelsPerNode, 4);
  }
}

TEST(LightLattice, IsEmptyAtFirst)
{
  LightLattice lattice(LightLattice::ShapeOfLight(glm::ivec3(20, 30, 40)));
  const std::uint8_t* const nodes = lattice.Nodes();
  for (std::size_t node = 0; node < lattice.Bytes(); ++node)
  {
    ASSERT_EQ(nodes[node], LightLattice::Empty) << node;
  }
}

TEST(LightLattice, OfAThinVolumeHasNoNodes)
{
  LightLattice lattice(LightLattice::ShapeOfLight(glm::ivec3(100, 100, 3)));
  EXPECT_EQ(lattice.Nodes(), nullptr);
  EXPECT_EQ(lattice.Bytes(), 0u);
}

// The box of a volume reaches half a voxel beyond its outermost ones.
TEST(LightLattice, OfTheSkyCoversAllPlacesThatSurfacesSeeItFrom)
{
  const glm::ivec3 voxels(5, 60, 2);
  const LatticeShape shape = LightLattice::ShapeOfSky(voxels);
  const double farthest = 0.5 + LightLattice::SkyDistanceVoxels;
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_LE(-shape.margin, -farthest);
    EXPECT_GE(shape.voxelsPerNode * (shape.nodeCount[axis] - 1) - shape.margin,
      voxels[axis] - 1 + farthest);
  }
}

TEST(LightLattice, OfTheSkyHasFewerNodesWhere32BitsCannotNumberThem)
{
  const LatticeShape shape = LightLattice::ShapeOfSky(glm::ivec3(1300));
  EXPECT_EQ(shape.voxelsPerNode, 2);
  EXPECT_GE(2 * (shape.nodeCount.x - 1) - shape.margin, 1302);
}
