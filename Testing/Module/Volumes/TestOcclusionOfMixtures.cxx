// Ambient occlusion of mixtures, that is of volumes that overlap and of several components: optical
// depths add up in each direction.

#include "Module/Volumes/MixedBalls.h"

#include <vtkPlane.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

using namespace varimarch;

namespace
{

constexpr double SkyTolerance = 1.0 / 64.0;

OverlapLight FromAllAround()
{
  OverlapLight light{ { { glm::normalize(glm::dvec3(0.7, 0.4, 0.5)) } } };
  light.hasShadows = false;
  light.occlusion = 0.8;
  light.occlusionReachMm = 3.0;
  return light;
}

double DifferenceOf(const std::vector<float>& drawn, const std::vector<float>& truth)
{
  return CompareImages(drawn.data(), truth.data(), truth.size() / 4).percentile999 / 255.0;
}

// Steps without a lattice, of which a software rasteriser allows enough along a ray.
void UseShortSteps(OverlapScene& scene)
{
  MapperOf(scene)->SetErrorTolerance(0.0);
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->SetSampleDistance(0.5f);
}

std::vector<float> DrawnByShaders(OverlapScene& scene)
{
  const std::vector<float> drawn = scene.Draw();
  EXPECT_TRUE(UsesPart(scene, "Sky/OpenSky.glsl"));
  return drawn;
}

std::vector<float> DrawnByPackets(OverlapScene& scene)
{
  const std::vector<float> drawn = scene.DrawByProcessor();
  EXPECT_TRUE(scene.ShaderParts().empty()) << "a shader has drawn it";
  return drawn;
}

// One component seen as the last of several that depend on each other, and alone.
void ExpectLikeOneComponent(int count)
{
  const auto ball = [&](glm::ivec3 voxel, int component) {
    return count == 4 && component < 3 ? 204.0 : BallField(glm::dvec3(voxel), { 6.0, 7.0, 6.0 });
  };
  OverlapScene one(12);
  OverlapScene several(12);
  const ComponentLook look{ { 0.8, 0.8, 0.8 }, 20.0, 100.0, 0.3 };
  for (OverlapScene* scene : { &one, &several })
  {
    const bool isOne = scene == &one;
    const auto image = ImageOf(VTK_UNSIGNED_CHAR, isOne ? 1 : count,
      [&](glm::ivec3 voxel, int component) { return ball(voxel, isOne ? 3 : component); },
      { 14, 15, 13 });
    image->SetOrigin(-6.5, -7.0, -6.0);
    vtkVolumeProperty* const property = scene->Add(0, image, look)->GetProperty();
    property->SetIndependentComponents(isOne);
    SetLook(property, 1, look);
    UseLight(*scene, FromAllAround());
    UseShortSteps(*scene);
    MapperOf(*scene)->SetIntegrationRule(vtkVariationFieldVolumeMapper::Midpoint);
  }
  const std::vector<float> alone = DrawnByPackets(one);
  EXPECT_LT(DifferenceOf(DrawnByPackets(several), alone), 1.5 / 255.0) << count;
  EXPECT_LT(DifferenceOf(DrawnByShaders(several), alone), 2.0 / 255.0) << count;
  MapperOf(several)->SetAmbientOcclusion(0.0);
  EXPECT_GT(DifferenceOf(several.Draw(), alone), 0.1) << count << ": occlusion is seen";
}

}

// The second case has boxes beside interpolated voxels.
TEST(OcclusionOfMixtures, DrawnByShadersIsThatOfTheReference)
{
  for (const bool hasBoxes : { false, true })
  {
    OverlapScene scene(8);
    AddBalls(scene, { true, false, false, hasBoxes });
    UseLight(scene, FromAllAround());
    UseShortSteps(scene);
    const std::vector<float> truth = TruthInLight(scene, FromAllAround(), 1e-3);
    const std::vector<float> drawn = DrawnByShaders(scene);
    EXPECT_LT(DifferenceOf(drawn, truth), 2.5 / 255.0) << hasBoxes;
    EXPECT_LT(DifferenceOf(drawn, DrawnByPackets(scene)), 2.5 / 255.0) << hasBoxes;
    MapperOf(scene)->SetAmbientOcclusion(0.0);
    EXPECT_GT(DifferenceOf(scene.Draw(), truth), 0.1) << "occlusion is seen";
  }
}

TEST(OcclusionOfMixtures, OfComponentsIsThatOfVolumesWithTheSameVoxels)
{
  MixedBalls balls(12);
  balls.Use(FromAllAround());
  const std::vector<float> truth = TruthInLight(balls.volumes, FromAllAround(), 1e-3);
  MapperOf(balls.components)->SetErrorTolerance(SkyTolerance);
  EXPECT_LT(DifferenceOf(DrawnByPackets(balls.components), truth), SkyTolerance);
  EXPECT_GT(MapperOf(balls.components)->GetLightMemoryBytes(), 0) << "there is a lattice";
  for (OverlapScene* scene : { &balls.volumes, &balls.components })
  {
    UseShortSteps(*scene);
    EXPECT_LT(DifferenceOf(DrawnByPackets(*scene), truth), 2.5 / 255.0);
    EXPECT_LT(DifferenceOf(DrawnByShaders(*scene), truth), 2.5 / 255.0);
  }
  EXPECT_TRUE(UsesPart(balls.components, "Outside/Components.glsl"));
  MapperOf(balls.components)->SetAmbientOcclusion(0.0);
  EXPECT_GT(DifferenceOf(balls.components.Draw(), truth), 0.05) << "occlusion is seen";
}

TEST(OcclusionOfMixtures, OfDependentComponentsIsThatOfTheOneWithTheOpacity)
{
  ExpectLikeOneComponent(2);
  ExpectLikeOneComponent(4);
}

// A plane cuts away the half of both volumes that is towards the eye.
TEST(OcclusionOfMixtures, EndsAtClippingPlanes)
{
  OverlapScene scene(12);
  AddBalls(scene, { true, true, false, false });
  UseLight(scene, FromAllAround());
  UseShortSteps(scene);
  scene.mapper->SetSampleDistance(0.25f); // packets march by another rule
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.0, 0.0, -1.0); // keeps what is below the origin
  scene.mapper->AddClippingPlane(plane);
  EXPECT_LT(DifferenceOf(DrawnByShaders(scene), DrawnByPackets(scene)), 2.5 / 255.0);
}

TEST(OcclusionOfMixtures, TakesNothingWhereItIsOff)
{
  OverlapScene scene(12);
  AddBalls(scene, { true, true, false, false });
  OverlapLight light = FromAllAround();
  UseLight(scene, light);
  UseShortSteps(scene);
  const auto draw = [&]
  {
    scene.Draw();
    return std::tuple(scene.ShaderParts(), MapperOf(scene)->GetGraphicsMemoryBytes());
  };
  DrawnByShaders(scene);
  const auto [parts, bytes] = draw();
  MapperOf(scene)->SetAmbientOcclusion(0.0);
  const auto [partsWithout, bytesWithout] = draw();
  EXPECT_TRUE(UsesPart(scene, "Sky/None.glsl"));
  EXPECT_FALSE(UsesPart(scene, "Sky/OpenSky.glsl"));
  EXPECT_FALSE(UsesPart(scene, "Through/"));
  EXPECT_FALSE(UsesPart(scene, "Around/"));
  EXPECT_LT(bytesWithout, bytes);
  EXPECT_LT(partsWithout.size(), parts.size());
}
