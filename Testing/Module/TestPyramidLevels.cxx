// Volumes in chunks and levels, in a memory that is too small for their voxels, each block of which
// is drawn by the coarsest level that serves.

#include "Module/MapperScene.h"
#include "Module/PyramidInChunks.h"
#include "Module/RefinedLevels.h"

#include <cmath>
#include <string>
#include <vector>

using namespace varimarch;

namespace
{

int SlowWaves(double x, double y, double z)
{
  return int(std::lround(500.0 + 200.0 * std::sin(0.02 * x) * std::cos(0.025 * y) + z));
}

// Slow waves but for a part of noise, for which the coarse levels do not suffice.
int WavesWithNoise(double x, double y, double z)
{
  const bool isNoise = std::abs(x - 60.0) < 20.0 && std::abs(y - 60.0) < 20.0;
  return isNoise ? 300 + int(37.0 * x + 101.0 * y + 59.0 * z) % 400 : SlowWaves(x, y, z);
}

void UseThinFog(MapperScene& scene)
{
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(0.0, 0.0);
  scene.opacities->AddPoint(1000.0, 0.01);
  scene.mapper->ProcessorMarchingOn();
  scene.mapper->SetErrorTolerance(1.0 / 32.0);
  constexpr vtkIdType EnoughToKeepPages = vtkIdType(1) << 40;
  scene.mapper->SetMaximumHostMemory(EnoughToKeepPages);
}

std::vector<float> Refined(MapperScene& scene)
{
  scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::RefinedLevel);
  std::vector<float> drawn = scene.Draw();
  for (int i = 0; i < 100 && scene.mapper->GetDrawnPart() < 1.0; ++i)
  {
    drawn = scene.Draw();
  }
  return drawn;
}

TEST_F(PyramidInChunks, LooksAsFromMemoryWithinTheTolerance)
{
  const std::string path = this->WritePyramid(WavesWithNoise);
  vtkNew<vtkImageData> inMemory;
  inMemory->DeepCopy(this->Read(path, 0));
  ASSERT_FALSE(this->reader->HasVoxelsOnDisk());
  MapperScene memory(inMemory);
  UseThinFog(memory);
  memory.mapper->SetErrorTolerance(1.0 / 1024.0);
  const std::vector<float> expected = memory.Draw();
  MapperScene disk(this->Read(path, MemoryForBricksOf8));
  ASSERT_TRUE(this->reader->HasVoxelsOnDisk());
  UseThinFog(disk);
  const std::vector<float> refined = Refined(disk);
  EXPECT_LE(disk.mapper->GetLevelErrorBound(), 1.0 / 64.0);
  EXPECT_LE(LargestDifference(refined, expected), 1.0 / 32.0);
  EXPECT_GT(disk.mapper->GetRefinedBlocks(), 0);
  EXPECT_LT(disk.mapper->GetRefinedBlocks(), disk.mapper->GetVisibleBlocks());
}

TEST_F(PyramidInChunks, TakesFewerVoxelsThanWithoutLevelsBetween)
{
  double wanted = 0.0;
  std::vector<vtkIdType> taken;
  for (const bool hasLevelsBetween : { true, false })
  {
    const auto at = [&](int level)
    {
      const int left = level > 0 && !hasLevelsBetween ? 3000 : 0; // see the next test
      return [left](double x, double y, double z) { return SlowWaves(x, y, z) + left; };
    };
    MapperScene scene(this->Read(this->WriteLevels(at), MemoryForBricksOf8));
    ASSERT_TRUE(this->reader->HasVoxelsOnDisk());
    UseThinFog(scene);
    scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::RefinedLevel);
    scene.Draw();
    scene.Draw();
    ASSERT_LT(scene.mapper->GetLevelErrorBound(), 1.0);
    wanted = hasLevelsBetween ? 0.6 * scene.mapper->GetLevelErrorBound() : wanted;
    scene.mapper->SetErrorTolerance(2.0 * wanted);
    Refined(scene);
    EXPECT_LE(scene.mapper->GetLevelErrorBound(), wanted);
    taken.push_back(scene.mapper->GetRefinedBlocks());
  }
  EXPECT_LT(4 * taken[0], taken[1]) << taken[0] << " of " << taken[1];
  this->RecordProperty("blocksWithLevelsBetween", int(taken[0]));
  this->RecordProperty("blocksWithout", int(taken[1]));
}

TEST_F(PyramidInChunks, LeavesOutLevelsWithValuesThatTheVoxelsDoNotHave)
{
  const auto brighter = [](int level)
  {
    return [level](double x, double y, double z)
    { return SlowWaves(x, y, z) + (level == 1 ? 3000 : 0); };
  };
  const std::string path = this->WriteLevels(brighter);
  MapperScene disk(this->Read(path, MemoryForBricksOf8));
  ASSERT_TRUE(this->reader->HasVoxelsOnDisk());
  UseThinFog(disk);
  this->DamageLevel(1);
  Refined(disk); // reports no error
  EXPECT_LE(disk.mapper->GetLevelErrorBound(), 1.0 / 64.0);
}

TEST_F(PyramidInChunks, IsReadAtItsFinestLevelInBricksThatFit)
{
  const std::string path = this->WritePyramid(WavesWithNoise);
  MapperScene large(this->Read(path, MemoryForBricksOf8));
  UseThinFog(large);
  EXPECT_EQ(large.image->GetDimensions()[0], LevelSize(0)[0]);
  const std::vector<float> inLargeBricks = large.Draw();
  MapperScene small(this->Read(path, MemoryForBricksOf4));
  ASSERT_TRUE(this->reader->HasVoxelsOnDisk());
  UseThinFog(small);
  EXPECT_LE(LargestDifference(small.Draw(), inLargeBricks), 1.0 / 32.0);
}

}
