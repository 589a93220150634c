#include "Core/Fields/BrickRows.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace varimarch;

TEST(LabelReach, IsTheLargestBlockOfOneLabel)
{
  std::mt19937 random(3);
  const glm::ivec3 size(11, 9, 7);
  std::vector<std::uint16_t> labels(size.x * size.y * size.z, 1);
  for (int i = 0; i < 6; ++i)
  {
    labels[random() % labels.size()] = std::uint16_t(random() % 3);
  }
  const std::vector<std::uint16_t> reach = LabelReach(labels, size);
  const auto at = [&](const auto& values, glm::ivec3 voxel)
  { return values[voxel.x + size.x * (voxel.y + size.y * voxel.z)]; };
  for (int index = 0; index < int(labels.size()); ++index)
  {
    const glm::ivec3 voxel(index % size.x, index / size.x % size.y, index / size.x / size.y);
    int nearest = 255; // distance to another label
    for (int other = 0; other < int(labels.size()); ++other)
    {
      const glm::ivec3 place(other % size.x, other / size.x % size.y, other / size.x / size.y);
      const glm::ivec3 apart = glm::abs(place - voxel);
      if (at(labels, place) != labels[index])
      {
        nearest = std::min(nearest, std::max({ apart.x, apart.y, apart.z }));
      }
    }
    EXPECT_EQ(at(reach, voxel), nearest);
  }
}
