// Volumes in chunks and levels, in a memory that is too small for their voxels, each block of which
// is drawn by the coarsest level that serves.

#include "Module/Paging/PyramidInChunks.h"
#include "Module/Paging/RefinedLevels.h"
#include "Module/Scenes/MapperScene.h"
#include "Support/ExpectedVtkErrors.h"

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

// The scales of levels may differ along the axes: microscopes halve slices, which are far apart.
TEST_F(PyramidInChunks, LooksAsFromMemoryWithinTheTolerance)
{
  for (const auto scaleOf : { EvenScale, ScaleThatKeepsSlices })
  {
    const std::string path = this->WritePyramid(WavesWithNoise, scaleOf);
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
}

/// The numbers of blocks of voxels with levels between the voxels and the means, and without.
class BlocksOfVoxels : public PyramidInChunks
{
protected:
  void Draw(const ScaleOf& scaleOf)
  {
    double wanted = 0.0;
    for (const bool hasLevelsBetween : { true, false })
    {
      const auto at = [&](int level)
      {
        const int left = level > 0 && !hasLevelsBetween ? 3000 : 0; // see a test below
        return [left](double x, double y, double z) { return SlowWaves(x, y, z) + left; };
      };
      MapperScene scene(this->Read(this->WriteLevels(at, scaleOf), MemoryForBricksOf8));
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
      (hasLevelsBetween ? this->with : this->without) = scene.mapper->GetRefinedBlocks();
    }
    this->RecordProperty("blocksWithLevelsBetween", int(this->with));
    this->RecordProperty("blocksWithout", int(this->without));
  }

  vtkIdType with = 0;
  vtkIdType without = 0;
};

TEST_F(BlocksOfVoxels, AreFewerThanWithoutLevelsBetween)
{
  this->Draw(EvenScale);
  EXPECT_LT(4 * this->with, this->without) << this->with << " of " << this->without;
}

// A level of half as many voxels along x and y is coarser too.
TEST_F(BlocksOfVoxels, AreFewerThanWithoutLevelsThatKeepSlices)
{
  this->Draw(ScaleThatKeepsSlices);
  EXPECT_LT(this->with, this->without) << this->with << " of " << this->without;
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

TEST_F(PyramidInChunks, ReportsDamagedChunksOfACoarserLevelOnce)
{
  MapperScene disk(this->Read(this->WritePyramid(SlowWaves), MemoryForBricksOf8));
  ASSERT_TRUE(this->reader->HasVoxelsOnDisk());
  UseThinFog(disk);
  this->DamageLevel(1);
  const ExpectedVtkErrors errors;
  Refined(disk);
  EXPECT_GE(errors.Messages().size(), 1u);
  EXPECT_NE(errors.Text().find("/1/"), std::string::npos) << errors.Text();
  EXPECT_NE(errors.Text().find("count as 0"), std::string::npos) << errors.Text();
  disk.Draw();
  EXPECT_EQ(errors.Messages().size(), 1u) << errors.Text();
}

TEST_F(PyramidInChunks, IsReadAtItsFinestLevelInBricksThatFit)
{
  const std::string path = this->WritePyramid(WavesWithNoise);
  MapperScene large(this->Read(path, MemoryForBricksOf8));
  UseThinFog(large);
  EXPECT_EQ(large.image->GetDimensions()[0], LevelSize(EvenScale(0))[0]);
  const std::vector<float> inLargeBricks = large.Draw();
  MapperScene small(this->Read(path, MemoryForBricksOf4));
  ASSERT_TRUE(this->reader->HasVoxelsOnDisk());
  UseThinFog(small);
  EXPECT_LE(LargestDifference(small.Draw(), inLargeBricks), 1.0 / 32.0);
}

}
