// Compositing from the back to the front gives the image of the usual order.

#include "Module/Scenes/MapperScene.h"
#include "Scene/Volumes/ProceduralVolume.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

// A scene in which both orders take the same samples: no field, no early end of rays.
void TakeAllSamples(MapperScene& scene)
{
  scene.mapper->SetAccelerationModeToOff();
  scene.mapper->SetIntegrationRule(vtkVariationFieldVolumeMapper::Midpoint);
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(0.7);
  scene.mapper->SetEarlyTerminationTransmittance(0.0);
}

std::vector<float> DrawIn(MapperScene& scene, int order)
{
  scene.mapper->SetCompositingOrder(order);
  return scene.Draw();
}

// Each of the few hundred sums of a ray is rounded to a float, in one order and in the other.
void ExpectSameImage(MapperScene& scene)
{
  constexpr double Rounding = 1e-5;
  const std::vector<float> forwards = DrawIn(scene, vtkVariationFieldVolumeMapper::FrontToBack);
  const std::vector<float> backwards = DrawIn(scene, vtkVariationFieldVolumeMapper::BackToFront);
  const varimarch::ImageError difference =
    varimarch::CompareImages(backwards.data(), forwards.data(), forwards.size() / 4);
  EXPECT_LT(difference.largest, 255.0 * Rounding);
  EXPECT_GT(*std::max_element(forwards.begin(), forwards.end()), 0.3f) << "nothing to compare";
}

// The mean number of fetches of a ray.
double FetchesIn(MapperScene& scene, int order)
{
  scene.mapper->DrawFetchCountsOn();
  const std::vector<float> counts = DrawIn(scene, order);
  scene.mapper->DrawFetchCountsOff();
  double sum = 0.0;
  for (std::size_t pixel = 0; pixel < counts.size(); pixel += 4)
  {
    sum += counts[pixel];
  }
  return sum / double(counts.size() / 4);
}

}

TEST(CompositingOrder, DoesNotChangeTheImage)
{
  for (const bool shaded : { false, true })
  {
    SCOPED_TRACE(shaded ? "shaded" : "unshaded");
    MapperScene scene(SmallTorso());
    scene.volume->GetProperty()->SetShade(shaded);
    TakeAllSamples(scene);
    ExpectSameImage(scene);
    EXPECT_TRUE(scene.UsesShaderPart(
      shaded ? "March/MaterialFromBehind.glsl" : "March/MidpointFromBehind.glsl"));
  }
}

TEST(CompositingOrder, DoesNotChangeRaysThatJitterBegins)
{
  MapperScene scene(SmallTorso());
  TakeAllSamples(scene);
  scene.mapper->UseJitteringOn();
  ExpectSameImage(scene);
}

TEST(CompositingOrder, DoesNotChangeRaysThatOtherSlotsDivide)
{
  MapperScene scene(SmallTorso());
  TakeAllSamples(scene);
  const double* const bounds = scene.image->GetBounds();
  std::array<double, 6> planes;
  for (int side = 0; side < 6; ++side)
  {
    const double* const axis = bounds + side / 2 * 2;
    planes[side] = axis[0] + (side % 2 == 0 ? 0.3 : 0.6) * (axis[1] - axis[0]);
  }
  scene.mapper->SetCroppingRegionPlanes(planes.data());
  scene.mapper->SetCroppingRegionFlags(VTK_CROP_FENCE);
  scene.mapper->CroppingOn();
  ExpectSameImage(scene);
}

TEST(CompositingOrder, DoesNotChangeAVolumeInBlocks)
{
  MapperScene scene(
    varimarch::ProceduralVolume({ varimarch::ProceduralKind::Torso, { 64, 56, 48 }, 7 }), 32);
  TakeAllSamples(scene);
  const std::vector<float> whole = DrawIn(scene, vtkVariationFieldVolumeMapper::BackToFront);
  scene.mapper->SetMaximumGraphicsMemory(200000);
  const std::vector<float> inBlocks = DrawIn(scene, vtkVariationFieldVolumeMapper::BackToFront);
  ASSERT_TRUE(scene.UsesShaderPart("Resume/Block.glsl")) << "the volume fits into one block";
  // Segments begin anew in each block; the error of either image is below this.
  EXPECT_LT(
    varimarch::CompareImages(inBlocks.data(), whole.data(), whole.size() / 4).rootMeanSquare, 0.5);
}

TEST(CompositingOrder, FromBehindTakesAllSamplesOfARay)
{
  MapperScene scene(SmallTorso());
  TakeAllSamples(scene);
  scene.opacities->AddPoint(0.0, 0.9); // rays end early
  scene.opacities->AddPoint(400.0, 0.99);
  const double whole = FetchesIn(scene, vtkVariationFieldVolumeMapper::FrontToBack);
  scene.mapper->SetEarlyTerminationTransmittance(0.05);
  const double ended = FetchesIn(scene, vtkVariationFieldVolumeMapper::FrontToBack);
  EXPECT_LT(ended, 0.9 * whole);
  EXPECT_NEAR(FetchesIn(scene, vtkVariationFieldVolumeMapper::BackToFront), whole, 0.01 * whole);
}

TEST(CompositingOrder, IsThatOfCompositesOnly)
{
  MapperScene scene(SmallTorso());
  scene.mapper->SetCompositingOrderToBackToFront();
  scene.mapper->SetBlendModeToMaximumIntensity();
  scene.Draw();
  EXPECT_TRUE(scene.UsesShaderPart("Step/BrickExtremes.glsl"));
}
