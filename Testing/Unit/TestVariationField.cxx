#include "ReferenceVolumes.h"
#include "VariationByBruteForce.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace varimarch;

namespace
{

/// A volume of values below `values`, with a few voxels of other values among them.
template <class Scalar>
OwnedVolume<Scalar> VariedVolume(glm::ivec3 dimensions, int values, int others, unsigned seed)
{
  OwnedVolume<Scalar> volume{ dimensions, {} };
  std::mt19937 random(seed);
  volume.voxels.resize(volume.Grid().VoxelCount());
  for (Scalar& voxel : volume.voxels)
  {
    voxel = Scalar(random() % values);
  }
  for (int i = 0; i < others; ++i)
  {
    volume.voxels[random() % volume.voxels.size()] = Scalar(10 + random() % 90);
  }
  return volume;
}

template <class Scalar>
void ExpectDefinitionHolds(const OwnedVolume<Scalar>& volume, double tolerance)
{
  for (const VoxelDistance kind : { VoxelDistance::Euclidean, VoxelDistance::Chebyshev })
  {
    const VariationField field = BuildVariationField(volume.Grid(), tolerance, kind);
    ASSERT_EQ(field.voxelCount, volume.dimensions);
    const glm::ivec3 count = volume.dimensions;
    for (int i = 0; i < count.x * count.y * count.z; ++i)
    {
      const glm::ivec3 voxel(i % count.x, i / count.x % count.y, i / count.x / count.y);
      ASSERT_EQ(int(field.voxels[i]), DistanceByBruteForce(volume, voxel, tolerance, kind))
        << "voxel " << voxel.x << " " << voxel.y << " " << voxel.z << " of " << count.x << " x "
        << count.y << " x " << count.z << ", distance " << int(kind);
    }
  }
}

template <class Scalar>
class VariationFieldOf : public testing::Test
{
};

using VoxelTypes = testing::Types<char, signed char, unsigned char, short, unsigned short, int,
  unsigned int, long, unsigned long, long long, unsigned long long, float, double>;
TYPED_TEST_SUITE(VariationFieldOf, VoxelTypes);

}

TYPED_TEST(VariationFieldOf, HoldsTheDistanceToTheNearestDifferentVoxel)
{
  ExpectDefinitionHolds(VariedVolume<TypeParam>({ 17, 10, 13 }, 3, 6, 1), 3.0);
  ExpectDefinitionHolds(VariedVolume<TypeParam>({ 11, 16, 9 }, 3, 4, 2), 2.5);
  ExpectDefinitionHolds(VariedVolume<TypeParam>({ 12, 7, 8 }, 100, 0, 3), 40.0);
}

TYPED_TEST(VariationFieldOf, NeverOverflows)
{
  using Limits = std::numeric_limits<TypeParam>;
  OwnedVolume<TypeParam> volume = VariedVolume<TypeParam>({ 6, 5, 4 }, 3, 0, 4);
  volume.voxels[30] = Limits::lowest();
  volume.voxels[90] = Limits::max();
  ExpectDefinitionHolds(volume, 3.0);
  ExpectDefinitionHolds(volume, double(Limits::max()));
}

TEST(VariationField, HoldsItsDefinitionInFlatAndOddVolumes)
{
  for (const glm::ivec3 dimensions : { glm::ivec3(1), glm::ivec3(1, 1, 40), glm::ivec3(40, 1, 1),
         glm::ivec3(1, 31, 22), glm::ivec3(23, 2, 31), glm::ivec3(3, 21, 1), glm::ivec3(2),
         glm::ivec3(33, 31, 2), glm::ivec3(20, 21, 19) })
  {
    for (const int others : { 1, 3 })
    {
      ExpectDefinitionHolds(VariedVolume<short>(dimensions, 3, others, 5), 3.0);
    }
  }
}

TEST(VariationField, EndsAtItsFarthestDistance)
{
  for (const glm::ivec3 dimensions :
    { glm::ivec3(600, 2, 1), glm::ivec3(1, 600, 2), glm::ivec3(2, 1, 600) })
  {
    ExpectDefinitionHolds(VariedVolume<unsigned char>(dimensions, 3, 1, 6), 3.0);
    ExpectDefinitionHolds(VariedVolume<unsigned char>(dimensions, 3, 0, 7), 3.0);
  }
}

TEST(VariationField, CountsADifferenceOfExactlyTheTolerance)
{
  const OwnedVolume<float> volume{ { 4, 1, 1 }, { 0.0f, 0.0f, 1.0f, 0.0f } };
  const auto build = [&](double tolerance)
  { return BuildVariationField(volume.Grid(), tolerance, VoxelDistance::Euclidean).voxels; };
  EXPECT_EQ(build(1.0), (std::vector<std::uint8_t>{ 2, 1, 1, 1 }));
  EXPECT_EQ(build(1.0 + 1e-9), std::vector<std::uint8_t>(4, VariationField::Farthest));
  EXPECT_EQ(build(0.0), std::vector<std::uint8_t>(4, 1)) << "no two voxels differ by less than 0";
}

TEST(VariationField, SeparatesABallFromACube)
{
  // The only different voxel is two voxels away along each axis: 2 in a cube, 3.46 in a ball.
  OwnedVolume<float> volume{ { 3, 3, 3 }, std::vector<float>(27) };
  volume.voxels.back() = 9.0f;
  const auto first = [&](VoxelDistance kind)
  { return int(BuildVariationField(volume.Grid(), 1.0, kind).voxels.front()); };
  EXPECT_EQ(first(VoxelDistance::Euclidean), 3);
  EXPECT_EQ(first(VoxelDistance::Chebyshev), 2);
}

TEST(VariationField, DiffersFromNonFiniteVoxelsAtAnyTolerance)
{
  for (const double bad : { std::nan(""), infinity, -infinity })
  {
    OwnedVolume<double> volume = VariedVolume<double>({ 9, 8, 7 }, 3, 0, 8);
    volume.voxels[200] = bad;
    ExpectDefinitionHolds(volume, 3.0);
    ExpectDefinitionHolds(volume, infinity);
    EXPECT_EQ(
      int(BuildVariationField(volume.Grid(), infinity, VoxelDistance::Euclidean).voxels[200]), 1);
  }
}

TEST(VariationField, RefusesBadTolerances)
{
  const OwnedVolume<float> volume{ { 2, 2, 2 }, std::vector<float>(8) };
  for (const double bad : { -1.0, std::nan("") })
  {
    EXPECT_THROW(
      BuildVariationField(volume.Grid(), bad, VoxelDistance::Euclidean), std::invalid_argument);
  }
}
