#include "CellFieldByBruteForce.h"
#include "ReferenceVolumes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace varimarch;

namespace
{

template <class Scalar>
std::size_t Count(const OwnedVolume<Scalar>& volume)
{
  return volume.Grid().VoxelCount();
}

/// Flat regions of all sizes with a few bumps between them, so that every radius occurs.
template <class Scalar>
OwnedVolume<Scalar> BumpyVolume(glm::ivec3 dimensions, int bumps, unsigned seed)
{
  OwnedVolume<Scalar> volume{ dimensions, {} };
  std::mt19937 random(seed);
  volume.voxels.resize(Count(volume));
  for (Scalar& voxel : volume.voxels)
  {
    voxel = Scalar(random() % 3);
  }
  for (int i = 0; i < bumps; ++i)
  {
    volume.voxels[random() % volume.voxels.size()] = Scalar(10 + random() % 90);
  }
  return volume;
}

template <class Scalar>
void ExpectFieldEqualsBruteForce(const OwnedVolume<Scalar>& volume, double tolerance)
{
  const CellField field = BuildCellField(volume.Grid(), tolerance);
  ASSERT_EQ(field.cellCount, volume.Grid().CellCount());
  std::size_t i = 0;
  for (int z = 0; z < field.cellCount.z; ++z)
  {
    for (int y = 0; y < field.cellCount.y; ++y)
    {
      for (int x = 0; x < field.cellCount.x; ++x, ++i)
      {
        ASSERT_EQ(int(field.cells[i]), SizeByBruteForce(volume, { x, y, z }, tolerance))
          << "cell " << x << " " << y << " " << z << " of " << volume.dimensions.x << " x "
          << volume.dimensions.y << " x " << volume.dimensions.z;
      }
    }
  }
}

}

template <class Scalar>
class CellFieldOf : public testing::Test
{
};

using ScalarTypes = testing::Types<char, signed char, unsigned char, short, unsigned short, int,
  unsigned int, long, unsigned long, long long, unsigned long long, float, double>;
TYPED_TEST_SUITE(CellFieldOf, ScalarTypes);

TYPED_TEST(CellFieldOf, HoldsTheLargestBlockThatKeepsTheTolerance)
{
  ExpectFieldEqualsBruteForce(BumpyVolume<TypeParam>({ 17, 10, 13 }, 6, 1), 2.0);
  ExpectFieldEqualsBruteForce(BumpyVolume<TypeParam>({ 17, 10, 13 }, 6, 2), 1.5);
}

TYPED_TEST(CellFieldOf, NeverOverflows)
{
  using Limits = std::numeric_limits<TypeParam>;
  OwnedVolume<TypeParam> volume = BumpyVolume<TypeParam>({ 6, 5, 4 }, 0, 3);
  volume.voxels[30] = Limits::lowest();
  volume.voxels[90] = Limits::max();
  ExpectFieldEqualsBruteForce(volume, 2.0);
  ExpectFieldEqualsBruteForce(volume, double(Limits::max()));
}

/// Values at any two positions in the block of a cell differ by at most the tolerance.
TYPED_TEST(CellFieldOf, KeepsThePromiseForInterpolatedValues)
{
  const OwnedVolume<TypeParam> volume = BumpyVolume<TypeParam>({ 19, 14, 16 }, 5, 4);
  const ScalarGrid<TypeParam> grid = volume.Grid();
  const CellField field = BuildCellField(grid, 2.0);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> fraction(0.0, 1.0);
  for (int i = 0; i < 20000; ++i)
  {
    const std::size_t index = random() % field.cells.size();
    if (field.cells[index] == 0)
    {
      continue;
    }
    const glm::dvec3 cell(int(index) % field.cellCount.x,
      int(index) / field.cellCount.x % field.cellCount.y,
      int(index) / field.cellCount.x / field.cellCount.y);
    const double radius = field.cells[index] - 1;
    const auto position = [&]
    {
      const glm::dvec3 place(fraction(random), fraction(random), fraction(random));
      return cell - radius + place * (2.0 * radius + 1.0);
    };
    ASSERT_LE(std::abs(grid.Value(position()) - grid.Value(position())), 2.0 + 1e-12);
  }
}

TEST(CellField, IsTheLargestAtAllFacesOfFlatAndOddVolumes)
{
  for (const glm::ivec3 dimensions : { glm::ivec3(1), glm::ivec3(1, 1, 40), glm::ivec3(40, 1, 1),
         glm::ivec3(1, 31, 22), glm::ivec3(23, 2, 31), glm::ivec3(3, 21, 1), glm::ivec3(2),
         glm::ivec3(33, 31, 2), glm::ivec3(20, 21, 19) })
  {
    for (const int bumps : { 1, 3 })
    {
      ExpectFieldEqualsBruteForce(BumpyVolume<short>(dimensions, bumps, 6), 2.0);
    }
  }
}

TEST(CellField, ReachesItsLargestRadiusAndNoFarther)
{
  for (const glm::ivec3 dimensions :
    { glm::ivec3(600, 2, 1), glm::ivec3(1, 600, 2), glm::ivec3(2, 1, 600) })
  {
    ExpectFieldEqualsBruteForce(BumpyVolume<unsigned char>(dimensions, 1, 7), 2.0);
    ExpectFieldEqualsBruteForce(BumpyVolume<unsigned char>(dimensions, 3, 8), 2.0);
    ExpectFieldEqualsBruteForce(BumpyVolume<unsigned char>(dimensions, 0, 9), 2.0);
  }
}

TEST(CellField, ConstantVolumeIsOneBlockAtToleranceZero)
{
  const OwnedVolume<float> volume{ { 9, 8, 7 }, std::vector<float>(9 * 8 * 7, 1e30f) };
  const CellField field = BuildCellField(volume.Grid(), 0.0);
  EXPECT_EQ(std::count(field.cells.begin(), field.cells.end(), CellField::LargestRadius + 1),
    std::ptrdiff_t(field.cells.size()));
}

TEST(CellField, NonFiniteVoxelsTouchOnlyTheBlocksThatHoldThem)
{
  for (const double bad : { std::nan(""), infinity, -infinity })
  {
    OwnedVolume<double> volume = BumpyVolume<double>({ 12, 11, 10 }, 0, 10);
    volume.voxels[3 + 12 * (4 + 11 * 5)] = bad;
    volume.voxels[4 + 12 * (4 + 11 * 5)] = bad;
    for (const double tolerance : { 2.0, 1e300, infinity })
    {
      ExpectFieldEqualsBruteForce(volume, tolerance);
    }
  }
}

TEST(CellField, InfiniteToleranceAcceptsEverythingFinite)
{
  const OwnedVolume<int> volume = BumpyVolume<int>({ 9, 8, 7 }, 50, 11);
  const CellField field = BuildCellField(volume.Grid(), infinity);
  EXPECT_EQ(
    *std::min_element(field.cells.begin(), field.cells.end()), CellField::LargestRadius + 1);
}

TEST(CellField, BadTolerancesAreRefused)
{
  const OwnedVolume<int> volume = BumpyVolume<int>({ 2, 2, 2 }, 0, 12);
  EXPECT_THROW(BuildCellField(volume.Grid(), -1.0), std::invalid_argument);
  EXPECT_THROW(BuildCellField(volume.Grid(), std::nan("")), std::invalid_argument);
}
