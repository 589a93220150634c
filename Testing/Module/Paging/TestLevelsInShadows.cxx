// Volumes that are drawn by coarse voxels in some blocks, in the shadows that they cast on
// themselves.

#include "Module/Paging/RefinedLevels.h"
#include "Module/Scenes/UsualSettings.h"

#include <vtkCamera.h>
#include <vtkInformation.h>
#include <vtkInformationDoubleKey.h>
#include <vtkLight.h>
#include <vtkRenderer.h>
#include <vtkVolumeProperty.h>

#include <functional>
#include <vector>

namespace
{

// A sun from the side, whose light the fog dims.
void UseShadows(MapperScene& scene)
{
  scene.volume->GetProperty()->ShadeOn();
  scene.volume->GetProperty()->SetSpecular(0.0);
  scene.renderer->AutomaticLightCreationOff();
  scene.renderer->RemoveAllLights();
  AddLight(scene.renderer, { 100.0, 40.0, 60.0 }, glm::dvec3(0.0));
  scene.mapper->ShadowsOn();
}

}

TEST_F(RefinedLevels, InShadowsLookLikeVoxelsWithinTheTolerance)
{
  MapperScene scene(this->ReadVoxels(Waves), 48);
  UseFog(scene, 0.0, 0.03);
  UseShadows(scene);
  scene.mapper->SetErrorTolerance(1.0 / 64.0);
  scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::VoxelLevel);
  const std::vector<float> voxels = scene.Draw();
  scene.mapper->ShadowsOff();
  const double ofShadows = LargestDifference(scene.Draw(), voxels);
  EXPECT_GT(ofShadows, 0.1) << "shadows are seen";
  scene.mapper->ShadowsOn();
  for (const double tolerance : { 1.0 / 8.0, 1.0 / 32.0 })
  {
    scene.mapper->SetErrorTolerance(tolerance);
    const std::vector<float> refined = DrawAll(scene);
    EXPECT_EQ(scene.mapper->GetUsedLevelOfDetail(), vtkVariationFieldVolumeMapper::RefinedLevel);
    EXPECT_LE(scene.mapper->GetLevelErrorBound(), 0.5 * tolerance);
    EXPECT_LE(LargestDifference(refined, voxels), tolerance);
  }
}

// A wall that the eye does not see keeps the light from a floor that it sees. Its coarse level is
// a third as dense, so that its voxels are needed; nothing is needed of what the light meets after
// the floor.
TEST_F(RefinedLevels, TakeVoxelsOfWhatIsBetweenThemAndALight)
{
  const auto sheet = [](int, int y, int z)
  {
    const bool isFloor = z < 8;
    const bool isWall = y >= 56 && z >= 30 && z < 50 && z % 3 == 0;
    return isFloor || isWall ? 1000 : 0;
  };
  MapperScene scene(this->ReadVoxels(sheet), 48);
  UseFog(scene, 0.0, 0.5);
  UseShadows(scene);
  scene.renderer->RemoveAllLights();
  AddLight(scene.renderer, { 0.0, 100.0, 100.0 }, glm::dvec3(0.0));
  vtkCamera* const camera = scene.renderer->GetActiveCamera();
  camera->SetFocalPoint(32.0, 20.0, 4.0);
  camera->SetPosition(32.0, 20.0, 100.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(15.0);
  camera->SetClippingRange(1.0, 200.0);
  scene.mapper->SetErrorTolerance(1.0 / 32.0);
  scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::VoxelLevel);
  const std::vector<float> voxels = scene.Draw();
  const std::vector<float> refined = DrawAll(scene);
  EXPECT_LE(LargestDifference(refined, voxels), 1.0 / 32.0);
  const vtkIdType inShadow = scene.mapper->GetRefinedBlocks();
  scene.mapper->ShadowsOff();
  DrawAll(scene);
  EXPECT_GT(inShadow, scene.mapper->GetRefinedBlocks());
  EXPECT_LT(inShadow, scene.mapper->GetVisibleBlocks()) << "not everything is read";
}

// Draws refined levels, and compares them with the voxels and with an image without the light that
// matter keeps.
void ExpectLevelsWithinTheTolerance(
  MapperScene& scene, const std::function<void()>& leaveOut, double leastEffect)
{
  constexpr double Tolerance = 1.0 / 16.0;
  scene.mapper->SetErrorTolerance(1.0 / 128.0);
  scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::VoxelLevel);
  const std::vector<float> voxels = scene.Draw();
  scene.mapper->SetErrorTolerance(Tolerance);
  scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::RefinedLevel);
  scene.Draw();
  std::vector<float> refined;
  for (int i = 0; i < 50 && scene.mapper->GetDrawnPart() < 1.0; ++i)
  {
    refined = scene.Draw();
    EXPECT_EQ(scene.mapper->GetUsedLevelOfDetail(), vtkVariationFieldVolumeMapper::RefinedLevel);
    EXPECT_LE(LargestDifference(refined, voxels),
      scene.mapper->GetLevelErrorBound() + 0.5 * Tolerance + 1.0 / 128.0)
      << i;
  }
  EXPECT_LE(scene.mapper->GetLevelErrorBound(), 0.5 * Tolerance);
  EXPECT_LE(LargestDifference(refined, voxels), Tolerance);
  leaveOut();
  scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::VoxelLevel);
  EXPECT_GT(LargestDifference(scene.Draw(), voxels), leastEffect);
}

vtkLight* UseLamp(MapperScene& scene)
{
  UseShadows(scene);
  scene.renderer->RemoveAllLights();
  vtkLight* const lamp =
    AddLight(scene.renderer, { 80.0, 50.0, 40.0 }, glm::dvec3(32.0, 32.0, 32.0));
  lamp->PositionalOn();
  return lamp;
}

TEST_F(RefinedLevels, InShadowsOfALampNearTheVolumeLookLikeVoxelsWithinTheTolerance)
{
  MapperScene scene(this->ReadVoxels(Waves), 32);
  UseFog(scene, 0.0, 0.03);
  UseLamp(scene);
  ExpectLevelsWithinTheTolerance(
    scene, [&] { scene.mapper->ShadowsOff(); }, 0.1);
}

TEST_F(RefinedLevels, UnderAmbientOcclusionLookLikeVoxelsWithinTheTolerance)
{
  MapperScene scene(this->ReadVoxels(Waves), 32);
  UseFog(scene, 0.0, 0.1);
  scene.mapper->SetAmbientOcclusion(1.0);
  scene.mapper->SetAmbientOcclusionReach(12.0);
  ExpectLevelsWithinTheTolerance(
    scene, [&] { scene.mapper->SetAmbientOcclusion(0.0); }, 0.05);
}

TEST_F(RefinedLevels, InShadowsOfASoftLampAreVoxels)
{
  MapperScene scene(this->ReadVoxels(Waves), 32);
  UseFog(scene, 0.0, 0.03);
  UseLamp(scene)->GetInformation()->Set(vtkVariationFieldVolumeMapper::LIGHT_SOFTNESS(), 10.0);
  scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::RefinedLevel);
  scene.Draw();
  EXPECT_EQ(scene.mapper->GetUsedLevelOfDetail(), vtkVariationFieldVolumeMapper::VoxelLevel);
}
