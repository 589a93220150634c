// Volumes in their file that are drawn by coarse voxels, except where the image needs theirs.

#include "Module/Paging/PagesInMemory.h"
#include "Module/Paging/RefinedLevels.h"

#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

TEST_F(RefinedLevels, LookLikeVoxelsWithinTheTolerance)
{
  MapperScene scene(this->ReadVoxels(Waves));
  UseFog(scene, 0.0, 0.03);
  scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::VoxelLevel);
  const std::vector<float> voxels = scene.Draw();
  for (const double tolerance : { 1.0 / 8.0, 1.0 / 64.0 })
  {
    scene.mapper->SetErrorTolerance(tolerance);
    const std::vector<float> refined = DrawAll(scene);
    EXPECT_LE(scene.mapper->GetLevelErrorBound(), 0.5 * tolerance);
    EXPECT_LE(LargestDifference(refined, voxels), 0.5 * tolerance + Steps);
    EXPECT_TRUE(scene.mapper->GetErrorToleranceIsKept());
  }
}

TEST_F(RefinedLevels, BecomeBetterWithEachImageUntilTheToleranceHolds)
{
  MapperScene scene(this->ReadVoxels(Waves));
  UseFog(scene, 0.0, 0.03);
  scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::RefinedLevel);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetUsedLevelOfDetail(), vtkVariationFieldVolumeMapper::CoarseLevel);
  EXPECT_FALSE(scene.mapper->GetErrorToleranceIsKept());
  double before = 1.0;
  vtkIdType blocks = -1;
  while (scene.mapper->GetDrawnPart() < 1.0)
  {
    scene.Draw();
    EXPECT_EQ(scene.mapper->GetUsedLevelOfDetail(), vtkVariationFieldVolumeMapper::RefinedLevel);
    EXPECT_LT(scene.mapper->GetLevelErrorBound(), before);
    EXPECT_GE(scene.mapper->GetRefinedBlocks(), blocks);
    before = scene.mapper->GetLevelErrorBound();
    blocks = scene.mapper->GetRefinedBlocks();
  }
  EXPECT_LE(before, 1.0 / 128.0);
  EXPECT_GT(blocks, 0);
  EXPECT_LE(blocks, scene.mapper->GetVisibleBlocks());
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetRefinedBlocks(), blocks) << "the tolerance holds";
}

// Each image of voxels that do not fit would read all of them anew.
TEST_F(RefinedLevels, EndWithOneImageOfVoxelsThatDoNotFit)
{
  vtkImageData* const voxels = this->ReadVoxels(Waves);
  std::array<int, 2> images = {};
  for (const bool fits : { true, false })
  {
    MapperScene scene(voxels);
    UseFog(scene, 0.0, 0.03);
    constexpr vtkIdType TooLittle = 400000;
    scene.mapper->SetMaximumHostMemory(fits ? scene.mapper->GetMaximumHostMemory() : TooLittle);
    scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::RefinedLevel);
    bool nextFits = true;
    int& count = images[fits ? 0 : 1];
    for (scene.Draw(), count = 1; scene.mapper->GetDrawnPart() < 1.0; ++count)
    {
      EXPECT_TRUE(nextFits) << "the last image is not the last";
      nextFits = scene.mapper->GetNextRefinementFits();
      scene.Draw();
    }
    EXPECT_EQ(nextFits, fits);
    EXPECT_LE(scene.mapper->GetLevelErrorBound(), 1.0 / 128.0);
  }
  EXPECT_LT(images[1], images[0]);
}

// Each pass over the rays of trial images would read them anew too: one has all half octaves.
TEST_F(RefinedLevels, HaveStepsOfHalfOctavesIfVoxelsDoNotFit)
{
  MapperScene scene(this->ReadVoxels(Waves));
  UseFog(scene, 0.0, 0.03);
  scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::VoxelLevel);
  const std::vector<float> voxels = scene.Draw();
  constexpr vtkIdType TooLittle = 400000;
  scene.mapper->SetMaximumHostMemory(TooLittle);
  scene.mapper->SetErrorTolerance(1.0 / 64.0);
  scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::RefinedLevel);
  const std::vector<float> drawn = DrawAll(scene);
  EXPECT_FALSE(scene.mapper->GetNextRefinementFits());
  const double halves = 2.0 * std::log2(scene.mapper->GetUsedSampleDistance());
  EXPECT_NEAR(halves, std::round(halves), 1e-3) << "the search was not of half octaves";
  EXPECT_LE(LargestDifference(drawn, voxels), 0.5 / 64.0 + Steps);
}

TEST_F(RefinedLevels, HaveStepsOfTheirOwnInEachImage)
{
  MapperScene scene(this->ReadVoxels(Waves));
  UseFog(scene, 0.0, 0.03);
  scene.mapper->SetErrorTolerance(1.0 / 64.0);
  scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::RefinedLevel);
  scene.Draw();
  int images = 0;
  while (scene.mapper->GetDrawnPart() < 1.0)
  {
    const int before = scene.mapper->GetToleranceSearches();
    scene.Draw();
    EXPECT_GT(scene.mapper->GetToleranceSearches(), before) << images;
    ++images;
  }
  EXPECT_GT(images, 1);
}

TEST_F(RefinedLevels, BeginAgainInAnotherView)
{
  MapperScene scene(this->ReadVoxels(Waves));
  UseFog(scene, 0.0, 0.03);
  DrawAll(scene);
  scene.renderer->GetActiveCamera()->Azimuth(20.0);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetUsedLevelOfDetail(), vtkVariationFieldVolumeMapper::CoarseLevel);
  EXPECT_LT(scene.mapper->GetDrawnPart(), 1.0);
}

// A ball of noise in fog of one density. The system reads 16 pages, 8 slices, for each that is
// touched.
TEST_F(RefinedLevels, ReadOnlyWhatTheImageNeeds)
{
  const auto ball = [](int x, int y, int z)
  {
    const int r2 = (x - 20) * (x - 20) + (y - 30) * (y - 30) + (z - 6) * (z - 6);
    return r2 < 36 ? 400 + (37 * x + 101 * y + 59 * z) % 400 : 300;
  };
  vtkImageData* const image = this->ReadVoxels(ball);
  MapperScene scene(image);
  UseFog(scene, 0.0, 0.02);
  const std::size_t before = PagesThere(image);
  const std::vector<float> refined = DrawAll(scene);
  const std::size_t touched = PagesThere(image) - before;
  EXPECT_LT(5 * scene.mapper->GetRefinedBlocks(), scene.mapper->GetVisibleBlocks());
  scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::VoxelLevel);
  EXPECT_LE(LargestDifference(refined, scene.Draw()), 1.0 / 128.0 + Steps);
  const std::size_t all = PagesThere(image) - before;
  EXPECT_GT(touched, 0u);
  EXPECT_LT(2 * touched, all);
}

TEST_F(RefinedLevels, ReadNothingOfOneMaterial)
{
  vtkImageData* const image = this->ReadVoxels([](int, int, int) { return 300; });
  MapperScene scene(image);
  UseFog(scene, 0.0, 0.05);
  const std::size_t before = PagesThere(image);
  DrawAll(scene);
  EXPECT_EQ(scene.mapper->GetRefinedBlocks(), 0);
  EXPECT_GT(scene.mapper->GetVisibleBlocks(), 0);
  EXPECT_EQ(PagesThere(image), before);
}

// A shell of fog in air, with and without light, which also needs values where rays begin and end.
TEST_F(RefinedLevels, ReadNothingBeforeTheErrorIsShown)
{
  const auto shell = [](int x, int y, int z)
  {
    const int r2 = (x - 32) * (x - 32) + (y - 32) * (y - 32) + (z - 32) * (z - 32);
    return r2 > 500 && r2 < 700 ? 300 + (37 * x + 101 * y + 59 * z) % 400 : 0;
  };
  vtkImageData* const image = this->ReadVoxels(shell);
  for (const bool isLit : { false, true })
  {
    MapperScene scene(image);
    UseFog(scene, 0.0, 0.02);
    scene.volume->GetProperty()->SetShade(isLit);
    scene.mapper->SetErrorTolerance(1.0 / 64.0);
    scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::RefinedLevel);
    const std::size_t before = PagesThere(image);
    scene.Draw();
    EXPECT_EQ(PagesThere(image), before);
    scene.Draw();
    EXPECT_EQ(scene.mapper->GetUsedLevelOfDetail(), vtkVariationFieldVolumeMapper::RefinedLevel);
    EXPECT_LT(scene.mapper->GetLevelErrorBound(), 1.0);
    EXPECT_EQ(scene.mapper->GetRefinedBlocks(), 0);
    EXPECT_EQ(PagesThere(image), before);
  }
}

// The fog is thicker from 400 to 650. A table of all values would have no entry there.
TEST_F(RefinedLevels, TellValuesApartThatAreFarFromAFillValue)
{
  constexpr int Fill = 1000000000;
  const auto waves = [](int x, int y, int z) { return x + y + z == 0 ? Fill : Waves(x, y, z); };
  MapperScene scene(this->ReadVoxels<float>(waves));
  UseFog(scene, 0.002, 0.002);
  constexpr double HalfWay = 0.5;
  constexpr double StepThere = 1.0;
  scene.opacities->AddPoint(200.0, 0.002, HalfWay, StepThere);
  scene.opacities->AddPoint(600.0, 0.05, HalfWay, StepThere);
  scene.opacities->AddPoint(700.0, 0.002);
  scene.colors->RemoveAllPoints();
  scene.colors->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  DrawAll(scene);
  EXPECT_GT(scene.mapper->GetRefinedBlocks(), 0);
}

TEST_F(RefinedLevels, AreVoxelsWhereNoBoundIsKnown)
{
  MapperScene scene(this->ReadVoxels(Waves));
  UseFog(scene, 0.0, 0.03);
  scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::RefinedLevel);
  scene.mapper->SetBlendModeToMaximumIntensity();
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetUsedLevelOfDetail(), vtkVariationFieldVolumeMapper::VoxelLevel);
  EXPECT_EQ(scene.mapper->GetDrawnPart(), 1.0);
}

TEST_F(RefinedLevels, AreVoxelsBetweenLayersOfTranslucentGeometry)
{
  MapperScene scene(this->ReadVoxels(Waves));
  UseFog(scene, 0.0, 0.03);
  const double middle[3] = { 0.5 * Side, 0.5 * Side, 0.5 * Side };
  const vtkSmartPointer<vtkActor> ball = Ball(middle, 0.2 * Side);
  ball->GetProperty()->SetOpacity(0.5);
  scene.renderer->AddActor(ball);
  UseDepthPeeling(scene.renderer);
  scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::RefinedLevel);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetUsedLevelOfDetail(), vtkVariationFieldVolumeMapper::VoxelLevel);
  EXPECT_EQ(scene.mapper->GetDrawnPart(), 1.0);
}

TEST_F(RefinedLevels, AreCompleteBeforeTheNextRoundWhereTheyComeInParts)
{
  MapperScene scene(this->ReadVoxels(Waves));
  UseFog(scene, 0.0, 0.03);
  scene.mapper->SetMaximumAccumulatedPictures(2);
  scene.mapper->SetLongestPartSeconds(1e-4);
  const std::vector<float> parts = DrawAll(scene);
  EXPECT_EQ(scene.mapper->GetAccumulatedPictures(), 2);
  EXPECT_LE(scene.mapper->GetLevelErrorBound(), 1.0 / 128.0);
}

TEST_F(RefinedLevels, AreCompleteInSeveralRenderersThatAreDrawnInTurn)
{
  MapperScene scene(this->ReadVoxels(Waves));
  UseFog(scene, 0.0, 0.03);
  vtkNew<vtkRenderer> beside;
  beside->SetViewport(0.5, 0.0, 1.0, 1.0);
  scene.renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  beside->AddVolume(scene.volume);
  scene.window->AddRenderer(beside);
  beside->ResetCamera();
  beside->GetActiveCamera()->Azimuth(60.0);
  const int images = RenderAll(scene);
  EXPECT_GT(images, 2);
  EXPECT_LT(images, 100);
  EXPECT_LE(scene.mapper->GetLevelErrorBound(), 1.0 / 128.0);

  // Each goes on by itself, and nobody waits for one that is not drawn any more.
  scene.renderer->GetActiveCamera()->Azimuth(20.0);
  scene.window->Render();
  EXPECT_LT(scene.mapper->GetDrawnPart(), 1.0) << "the other one is complete";
  scene.window->RemoveRenderer(scene.renderer);
  EXPECT_LT(RenderAll(scene), 4);
  scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::VoxelLevel);
  scene.window->Render();
  EXPECT_EQ(scene.mapper->GetDrawnPart(), 1.0);
}

TEST_F(RefinedLevels, AreCompleteForBothEyes)
{
  MapperScene scene(this->ReadVoxels(Waves));
  UseFog(scene, 0.0, 0.03);
  scene.window->SetStereoTypeToRedBlue();
  scene.window->StereoRenderOn();
  const int images = RenderAll(scene);
  EXPECT_GT(images, 2);
  EXPECT_LT(images, 100);
  EXPECT_LE(scene.mapper->GetLevelErrorBound(), 1.0 / 128.0);
}

TEST_F(RefinedLevels, BeginVoxelsThatComeInPartsAtOnce)
{
  MapperScene scene(this->ReadVoxels(Waves));
  UseFog(scene, 0.0, 0.03);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetUsedLevelOfDetail(), vtkVariationFieldVolumeMapper::VoxelLevel);
  EXPECT_EQ(scene.mapper->GetDrawnPart(), 1.0) << "no parts are wanted";
  scene.mapper->SetErrorTolerance(1.0 / 64.0);
  scene.mapper->SetLongestPartSeconds(100.0);
  int before = vtkVariationFieldVolumeMapper::CoarseLevel;
  int images = 0;
  do
  {
    scene.Draw();
    const int level = scene.mapper->GetUsedLevelOfDetail();
    EXPECT_TRUE(
      level == before || (images > 0 && before != vtkVariationFieldVolumeMapper::VoxelLevel));
    EXPECT_EQ(
      scene.mapper->GetErrorToleranceIsKept(), level == vtkVariationFieldVolumeMapper::VoxelLevel);
    before = level;
    ++images;
  } while (scene.mapper->GetDrawnPart() < 1.0 && images < 100);
  EXPECT_EQ(before, vtkVariationFieldVolumeMapper::VoxelLevel);
  EXPECT_LT(images, 100);

  // A volume in memory has no levels, whatever was not complete before.
  scene.renderer->GetActiveCamera()->Azimuth(20.0);
  scene.Draw();
  EXPECT_LT(scene.mapper->GetDrawnPart(), 1.0);
  scene.mapper->SetInputData(SmallTorso());
  scene.mapper->SetLongestPartSeconds(0.0);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetDrawnPart(), 1.0);
}
