// Nearest-neighbour interpolation, VTK's default: voxels are boxes of one value, rendered exactly.

#include "Module/Scenes/MapperScene.h"
#include "Scene/Volumes/ProceduralVolume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

using namespace varimarch;

namespace
{

constexpr int NearestSize = 64;

// Allows for the rounding of floats; nothing is sampled. A few rays graze the edge of their largest
// voxel, and may or may not see it.
void ExpectExact(MapperScene& scene)
{
  const ImageError error = scene.Error();
  EXPECT_LT(error.rootMeanSquare,
    scene.mapper->GetBlendMode() == vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND ? 0.3 : 0.02);
  EXPECT_LT(error.percentile999, 0.3);
  const std::vector<float> drawn = scene.Draw();
  EXPECT_GT(*std::max_element(drawn.begin(), drawn.end()), 0.1f) << "nothing is visible";
}

}

TEST(Nearest, IsTheDefaultOfAProperty)
{
  MapperScene scene(SmallTorso(), NearestSize);
  vtkNew<vtkVolumeProperty> property;
  property->SetColor(scene.colors);
  property->SetScalarOpacity(scene.opacities);
  scene.volume->SetProperty(property);
  scene.Draw();
  EXPECT_TRUE(scene.UsesShaderPart("March/Voxels.glsl"));
  property->SetInterpolationTypeToLinear();
  scene.Draw();
  EXPECT_FALSE(scene.UsesShaderPart("March/Voxels.glsl"));
}

class NearestOfBlend : public testing::TestWithParam<int>
{
};

TEST_P(NearestOfBlend, IsTheTruthWhateverTheField)
{
  for (const int mode : { vtkVariationFieldVolumeMapper::Off,
         vtkVariationFieldVolumeMapper::CellField, vtkVariationFieldVolumeMapper::OpticalField })
  {
    SCOPED_TRACE(mode);
    MapperScene scene(SmallTorso(), NearestSize);
    scene.mapper->SetBlendMode(GetParam());
    scene.mapper->SetAccelerationMode(mode);
    scene.mapper->SetEarlyTerminationTransmittance(0.0);
    scene.volume->GetProperty()->SetInterpolationTypeToNearest();
    scene.opacities->AddPoint(-1100.0, 0.3);
    scene.opacities->AddPoint(-400.0, 0.0);
    ExpectExact(scene);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryBlend, NearestOfBlend,
  testing::Values(int(vtkVolumeMapper::COMPOSITE_BLEND),
    int(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND), int(vtkVolumeMapper::MINIMUM_INTENSITY_BLEND),
    int(vtkVolumeMapper::AVERAGE_INTENSITY_BLEND), int(vtkVolumeMapper::ADDITIVE_BLEND)));

TEST(Nearest, AVoxelHasOneNormal)
{
  for (const int mode :
    { vtkVariationFieldVolumeMapper::Off, vtkVariationFieldVolumeMapper::OpticalField })
  {
    MapperScene scene(SmallTorso(), NearestSize);
    scene.mapper->SetAccelerationMode(mode);
    scene.mapper->SetEarlyTerminationTransmittance(0.0);
    scene.volume->GetProperty()->SetInterpolationTypeToNearest();
    scene.volume->GetProperty()->ShadeOn();
    ExpectExact(scene);
    EXPECT_TRUE(scene.UsesShaderPart("March/MaterialVoxels.glsl"));
  }
}

TEST(Nearest, IsCutAndTurnedLikeEverythingElse)
{
  MapperScene scene(SmallTorso(), NearestSize);
  scene.mapper->SetEarlyTerminationTransmittance(0.0);
  scene.volume->GetProperty()->SetInterpolationTypeToNearest();
  scene.volume->SetScale(1.2, 0.8, 1.0);
  scene.volume->RotateWXYZ(35.0, 0.3, 1.0, 0.2);
  scene.renderer->ResetCamera();
  double bounds[6];
  scene.image->GetBounds(bounds);
  scene.mapper->CroppingOn();
  scene.mapper->SetCroppingRegionPlanes(0.7 * bounds[0], 0.6 * bounds[1], 0.7 * bounds[2],
    0.8 * bounds[3], 0.7 * bounds[4], 0.5 * bounds[5]);
  scene.mapper->SetCroppingRegionFlags(VTK_CROP_FENCE);
  ExpectExact(scene);
}

TEST(Nearest, IsTheSameInBlocks)
{
  MapperScene scene(ProceduralVolume({ ProceduralKind::Torso, { 64, 56, 48 }, 7 }), NearestSize);
  scene.volume->GetProperty()->SetInterpolationTypeToNearest();
  const std::vector<float> whole = scene.Draw();
  scene.mapper->SetMaximumGraphicsMemory(200000);
  const std::vector<float> inBlocks = scene.Draw();
  EXPECT_TRUE(scene.UsesShaderPart("Resume/Block.glsl"));
  EXPECT_LT(CompareImages(inBlocks.data(), whole.data(), whole.size() / 4).percentile999, 0.3);
}

TEST(Nearest, NeedsNoStepsAndSearchesForNone)
{
  MapperScene scene(SmallTorso(), NearestSize);
  scene.mapper->SetErrorTolerance(1.0 / 64.0);
  scene.volume->GetProperty()->SetInterpolationTypeToNearest();
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), 0);
  EXPECT_EQ(scene.mapper->GetEstimatedError(), 0.0);
  EXPECT_LT(scene.Error().largest, 255.0 / 64.0);
}
