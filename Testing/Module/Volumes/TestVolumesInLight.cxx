// Shadows, scattered light and ambient occlusion of volumes that overlap: optical depths add up
// along a ray to a light.

#include "Module/Volumes/MixedBalls.h"

#include <vtkPlane.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

using namespace varimarch;

namespace
{

const glm::dvec3 fromTheSide = glm::normalize(glm::dvec3(0.7, 0.4, 0.5));
const glm::dvec3 fromBehind = glm::normalize(glm::dvec3(-0.6, 0.5, -0.4));
constexpr double Tolerance = 1.0 / 64.0;

ImageError ErrorOf(const std::vector<float>& drawn, const std::vector<float>& truth)
{
  return CompareImages(drawn.data(), truth.data(), truth.size() / 4);
}

// A box of one opacity, whose values rise along its last axis, so that it has a normal.
vtkSmartPointer<vtkImageData> FacingBox(glm::dvec3 sizeMm)
{
  return CenteredImage({ 5, 4, 6 }, sizeMm, [](glm::dvec3 voxel) { return 1.0 + voxel.z; });
}

// A ball in the middle of the world, in a cube of a side [mm].
vtkSmartPointer<vtkImageData> Ball(double side)
{
  return CenteredImage({ 14, 14, 14 }, glm::dvec3(side),
    [](glm::dvec3 voxel) { return BallField(voxel, glm::dvec3(6.5)); });
}

enum class Caster
{
  Lit,
  Unlit,
};

// Two balls at an angle, with voxels of different sizes, that overlap in the middle.
struct LitBalls
{
  explicit LitBalls(int size = 16, const BallLooks& looks = { true, true, false, false })
    : scene(size)
  {
    AddBalls(this->scene, looks);
    MapperOf(this->scene)->SetErrorTolerance(Tolerance);
  }

  std::vector<float> DrawnByPackets()
  {
    const std::vector<float> drawn = this->scene.DrawByProcessor();
    EXPECT_STREQ(this->scene.mapper->GetReasonForVtkMapper(), "");
    EXPECT_TRUE(this->scene.ShaderParts().empty()) << "a shader has drawn it";
    return drawn;
  }

  OverlapScene scene;
};

void ExpectWithin(const std::vector<float>& drawn, const std::vector<float>& truth)
{
  EXPECT_LT(ErrorOf(drawn, truth).percentile999, 255.0 * Tolerance);
}

}

// The light at a place is exp of minus the summed optical depths of the lengths in both boxes.
TEST(VolumesInLight, HomogeneousBoxesHaveTheirClosedForm)
{
  OverlapScene scene(16);
  const ComponentLook red{ { 0.9, 0.2, 0.1 }, -2.0, -1.0, 0.1 };
  const ComponentLook blue{ { 0.1, 0.3, 0.8 }, -2.0, -1.0, 0.05 };
  scene.Add(0, FacingBox({ 12.0, 16.0, 10.0 }), red)->GetProperty()->ShadeOn();
  vtkVolume* const second = scene.Add(1, FacingBox({ 18.0, 8.0, 14.0 }), blue);
  second->GetProperty()->ShadeOn();
  second->SetPosition(5.0, -2.0, 1.0);
  second->RotateWXYZ(40.0, 1.0, 2.0, 3.0);
  OverlapLight light{ { { fromTheSide } } };
  UseLight(scene, light);
  MapperOf(scene)->SetErrorTolerance(Tolerance);
  const std::vector<float> truth = TruthInLight(scene, light, 1e-4);
  ExpectWithin(scene.DrawByProcessor(), truth);
  ASSERT_STREQ(scene.mapper->GetReasonForVtkMapper(), "");
  ASSERT_TRUE(scene.ShaderParts().empty());
  light.hasShadows = false;
  EXPECT_GT(ErrorOf(TruthInLight(scene, light, 1e-3), truth).percentile999, 30.0)
    << "shadows are seen";
}

TEST(VolumesInLight, KeepTheErrorTolerance)
{
  LitBalls balls;
  const OverlapLight light{ { { fromTheSide }, { fromBehind } } };
  UseLight(balls.scene, light);
  const std::vector<float> truth = TruthInLight(balls.scene, light, 4e-4);
  for (const double tolerance : { 1.0 / 16.0, 1.0 / 64.0, 1.0 / 255.0 })
  {
    MapperOf(balls.scene)->SetErrorTolerance(tolerance);
    EXPECT_LT(ErrorOf(balls.DrawnByPackets(), truth).percentile999, 255.0 * tolerance) << tolerance;
    EXPECT_GT(MapperOf(balls.scene)->GetLightMemoryBytes(), 0);
  }
  MapperOf(balls.scene)->ShadowsOff();
  EXPECT_GT(ErrorOf(balls.DrawnByPackets(), truth).percentile999, 20.0) << "shadows are seen";
}

TEST(VolumesInLight, OfAHeadLightAndAKeyLightKeepTheErrorTolerance)
{
  LitBalls balls;
  OverlapLight light{ { { fromTheSide } } };
  light.hasHeadLight = true;
  UseLight(balls.scene, light);
  ExpectWithin(balls.DrawnByPackets(), TruthInLight(balls.scene, light, 1e-3));
}

TEST(VolumesInLight, OneOfThemInBoxesKeepTheErrorTolerance)
{
  LitBalls balls(16, { true, true, false, true });
  const OverlapLight light{ { { fromTheSide } } };
  UseLight(balls.scene, light);
  ExpectWithin(balls.DrawnByPackets(), TruthInLight(balls.scene, light, 1e-3));
}

// Rays of the eye go from face to face, but their light is sampled or that of lattices.
TEST(VolumesInLight, AllInBoxesKeepTheErrorTolerance)
{
  LitBalls balls(8, { true, true, true, true });
  OverlapLight light{ { { fromTheSide } } };
  for (const auto& [hasShadows, occlusion] : { std::pair(false, 0.8), std::pair(true, 0.0) })
  {
    light.hasShadows = hasShadows;
    light.occlusion = occlusion;
    UseLight(balls.scene, light);
    ExpectWithin(balls.DrawnByPackets(), TruthInLight(balls.scene, light, 1e-3));
    EXPECT_GT(MapperOf(balls.scene)->GetToleranceSearches(), 0);
  }
}

TEST(VolumesInLight, OfASoftLightKeepTheErrorTolerance)
{
  LitBalls balls(12);
  const OverlapLight light{ { { fromTheSide, 20.0 } } };
  UseLight(balls.scene, light);
  ExpectWithin(balls.DrawnByPackets(), TruthInLight(balls.scene, light, 1e-3));
}

// Each of two plates dims half of a wide light, so that all of it is dimmed once.
TEST(VolumesInLight, DimASoftLightDirectionByDirection)
{
  OverlapScene scene(12);
  scene.Add(0, Ball(13.4), ballLooks[0])->GetProperty()->ShadeOn();
  for (int port : { 1, 2 })
  {
    vtkVolume* const plate =
      scene.Add(port, FacingBox({ 1.0, 20.0, 40.0 }), { { 0.3, 0.3, 0.9 }, -2.0, -1.0, 0.7 });
    plate->SetPosition(10.0, port == 1 ? -10.0 : 10.0, 0.0);
  }
  const OverlapLight light{ { { { 1.0, 0.0, 0.0 }, 45.0 } } };
  UseLight(scene, light);
  MapperOf(scene)->SetErrorTolerance(Tolerance);
  ExpectWithin(scene.DrawByProcessor(), TruthInLight(scene, light, 1e-3));
  EXPECT_TRUE(scene.ShaderParts().empty()) << "a shader has drawn it";
}

class LightPastGeometry : public testing::TestWithParam<double>
{
};

TEST_P(LightPastGeometry, KeepsTheErrorToleranceInBothVolumes)
{
  LitBalls balls(12);
  OverlapLight light{ { { glm::normalize(glm::dvec3(1.0, 0.3, 0.1)), GetParam() } } };
  light.opaque = Box{ { 13.0, 2.0, -5.0 }, { 14.0, 11.3, 3.0 } };
  UseLight(balls.scene, light);
  const std::vector<float> truth = TruthInLight(balls.scene, light, 1e-3);
  ExpectWithin(balls.DrawnByPackets(), truth);
  light.opaque.reset();
  EXPECT_GT(ErrorOf(TruthInLight(balls.scene, light, 1e-3), truth).percentile999, 20.0)
    << "the shadow of the box is seen";
}

INSTANTIATE_TEST_SUITE_P(HardAndSoft, LightPastGeometry, testing::Values(0.0, 20.0));

TEST(VolumesInLight, ThatScatterItKeepTheErrorTolerance)
{
  LitBalls balls;
  OverlapLight light{ { { fromTheSide } } };
  light.isScattered = true;
  UseLight(balls.scene, light);
  ExpectWithin(balls.DrawnByPackets(), TruthInLight(balls.scene, light, 1e-3));
}

TEST(VolumesInLight, ThatOccludeEachOtherKeepTheErrorTolerance)
{
  LitBalls balls(12);
  OverlapLight light{ { { fromTheSide } } };
  light.hasShadows = false;
  light.occlusion = 0.8;
  UseLight(balls.scene, light);
  const std::vector<float> truth = TruthInLight(balls.scene, light, 1e-3);
  ExpectWithin(balls.DrawnByPackets(), truth);
  MapperOf(balls.scene)->SetAmbientOcclusion(0.0);
  EXPECT_GT(ErrorOf(balls.DrawnByPackets(), truth).percentile999, 20.0) << "occlusion is seen";
}

class ShadowOnAnother : public testing::TestWithParam<Caster>
{
};

// A box beside a ball, which it does not touch, takes the light that comes from its side.
TEST_P(ShadowOnAnother, IsCastByAVolumeThatDoesNotOverlap)
{
  OverlapScene scene(16);
  scene.Add(0, Ball(14.0), ballLooks[0])->GetProperty()->ShadeOn();
  vtkVolume* const box =
    scene.Add(1, FacingBox({ 3.0, 9.0, 9.0 }), { { 0.3, 0.3, 0.9 }, -2.0, -1.0, 0.3 });
  box->SetPosition(9.0, 2.0, 0.0);
  box->RotateZ(10.0);
  OverlapLight light{ { { glm::normalize(glm::dvec3(1.0, 0.2, 0.1)) } } };
  box->GetProperty()->SetShade(GetParam() == Caster::Lit);
  UseLight(scene, light);
  MapperOf(scene)->SetErrorTolerance(Tolerance);
  const std::vector<float> truth = TruthInLight(scene, light, 1e-3);
  ExpectWithin(scene.DrawByProcessor(), truth);
  ASSERT_TRUE(scene.ShaderParts().empty());
  // Without the box's opacity there is no shadow on the ball.
  scene.Remove(1);
  const auto middle = std::size_t(4 * (8 * 16 + 8));
  EXPECT_GT(scene.DrawByProcessor()[middle], truth[middle] + 0.05);
}

INSTANTIATE_TEST_SUITE_P(EveryCaster, ShadowOnAnother, testing::Values(Caster::Lit, Caster::Unlit),
  [](const testing::TestParamInfo<Caster>& info)
  { return info.param == Caster::Lit ? "Lit" : "Unlit"; });

// Two volumes with the same voxels are one volume with two components.
TEST(VolumesInLight, AreLikeComponentsOfOne)
{
  MixedBalls balls(24);
  balls.Use({ { { fromTheSide } } });
  for (OverlapScene* scene : { &balls.volumes, &balls.components })
  {
    MapperOf(*scene)->SetErrorTolerance(1.0 / 255.0);
  }
  const std::vector<float> drawn = balls.volumes.DrawByProcessor();
  const std::vector<float> ofComponents = balls.components.DrawByProcessor();
  EXPECT_TRUE(balls.components.ShaderParts().empty()) << "a shader has drawn it";
  EXPECT_LT(ErrorOf(drawn, ofComponents).percentile999, 2.0);
  MapperOf(balls.volumes)->ShadowsOff();
  EXPECT_GT(ErrorOf(balls.volumes.DrawByProcessor(), drawn).percentile999, 10.0)
    << "shadows are seen";
}

// Shaders of a software rasterizer have long steps, which short rays bear.
TEST(VolumesInLight, DrawnByShadersAreThoseOfPackets)
{
  LitBalls balls(12, { true, false, false, false });
  const OverlapLight light{ { { fromTheSide } } };
  UseLight(balls.scene, light);
  MapperOf(balls.scene)->SetErrorTolerance(0.0);
  balls.scene.mapper->AutoAdjustSampleDistancesOff();
  balls.scene.mapper->SetSampleDistance(0.2f);
  const std::vector<float> marched = balls.DrawnByPackets();
  const std::vector<float> drawn = balls.scene.Draw();
  ASSERT_TRUE(UsesPart(balls.scene, "Around/Volumes.glsl"));
  EXPECT_LT(ErrorOf(drawn, marched).percentile999, 4.0);
  EXPECT_LT(ErrorOf(drawn, TruthInLight(balls.scene, light, 1e-3)).percentile999, 4.0);
}

TEST(VolumesInLight, WithoutShadowsHaveNeitherCodeNorLattices)
{
  LitBalls balls;
  OverlapLight light{ { { fromTheSide } } };
  UseLight(balls.scene, light);
  balls.DrawnByPackets();
  EXPECT_GT(MapperOf(balls.scene)->GetLightMemoryBytes(), 0);
  light.hasShadows = false;
  UseLight(balls.scene, light);
  balls.DrawnByPackets();
  EXPECT_EQ(MapperOf(balls.scene)->GetLightMemoryBytes(), 0);
  balls.scene.Draw();
  EXPECT_FALSE(UsesPart(balls.scene, "Through/"));
  EXPECT_FALSE(UsesPart(balls.scene, "Around/"));
  EXPECT_TRUE(UsesPart(balls.scene, "Reach/None.glsl"));
}

// Factors of a light have smaller errors than all of it.
TEST(VolumesInLight, KeepNoLightThatOneOfThemHadAlone)
{
  const OverlapLight light{ { { fromTheSide } } };
  const auto first = Ball(14.0);
  const auto addFirst = [&](OverlapScene& scene)
  {
    scene.Add(0, first, ballLooks[1])->GetProperty()->ShadeOn();
    UseLight(scene, light);
    MapperOf(scene)->SetErrorTolerance(1.0 / 255.0);
  };
  const auto drawBoth = [&](OverlapScene& scene)
  {
    scene.Add(1, FacingBox({ 3.0, 9.0, 9.0 }), { { 0.3, 0.3, 0.9 }, -2.0, -1.0, 0.1 })
      ->SetPosition(6.0, 2.0, 0.0);
    UseLight(scene, light);
    return scene.DrawByProcessor();
  };
  OverlapScene kept(24);
  addFirst(kept);
  const std::vector<float> alone = kept.DrawByProcessor();
  const int ofOne = MapperOf(kept)->GetLightLatticeBuilds();
  EXPECT_EQ(ofOne, 1);
  OverlapScene fresh(24);
  addFirst(fresh);
  const std::vector<float> both = drawBoth(kept);
  EXPECT_EQ(both, drawBoth(fresh));
  EXPECT_NE(both, alone);
  EXPECT_EQ(MapperOf(kept)->GetLightLatticeBuilds(), ofOne + 2);
}

// The eye sees exp(-e z) of what exp(-e z) of the light excites at depth z: half of the light that
// a face would send, however dense the matter is.
TEST(VolumesInLight, OfDenseMatterHaveTheirClosedForm)
{
  for (const int interpolation : { VTK_NEAREST_INTERPOLATION, VTK_LINEAR_INTERPOLATION })
  {
    for (const double opacity : { 0.9, 0.99999, 1.0 })
    {
      OverlapScene scene(16);
      const ComponentLook look{ { 0.9, 0.5, 0.3 }, -2.0, -1.0, opacity };
      for (int port = 0; port < 2; ++port)
      {
        vtkVolume* const box = scene.Add(port, FacingBox({ 30.0, 30.0, 8.0 }), look);
        box->GetProperty()->ShadeOn();
        box->GetProperty()->SetInterpolationType(interpolation);
        box->SetPosition(0.0, 0.0, -10.0 * port);
      }
      UseLight(scene, { { { { 0.0, 0.0, 1.0 } } } });
      MapperOf(scene)->SetErrorTolerance(Tolerance);
      EXPECT_NEAR(scene.DrawByProcessor()[4 * (8 * 16 + 8)], 0.8 * look.color.r * 0.5, Tolerance)
        << interpolation << ", " << opacity;
      EXPECT_TRUE(scene.ShaderParts().empty()) << "a shader has drawn it";
    }
  }
}

// A plane cuts away the half of both volumes that is towards the light.
TEST(VolumesInLight, ThatAreClippedCastNoShadows)
{
  OverlapScene scene(16);
  const ComponentLook look{ { 0.9, 0.5, 0.3 }, -2.0, -1.0, 0.15 };
  for (int port = 0; port < 2; ++port)
  {
    vtkVolume* const box = scene.Add(port, FacingBox({ 30.0, 30.0, 8.0 }), look);
    box->GetProperty()->ShadeOn();
    box->RotateZ(30.0 * port);
  }
  OverlapLight light{ { { { 0.0, 0.0, 1.0 } } } };
  UseLight(scene, light);
  MapperOf(scene)->SetErrorTolerance(Tolerance);
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.0, 0.0, -1.0); // keeps what is below the origin
  scene.mapper->AddClippingPlane(plane);
  const double extinction = -2.0 * std::log1p(-look.opacity);
  // The eye sees exp(-e z) of what exp(-e z) of the light excites at depth z.
  const double expected = 0.8 * look.color.r * 0.5 * (1.0 - std::exp(-2.0 * extinction * 4.0));
  EXPECT_NEAR(scene.DrawByProcessor()[4 * (8 * 16 + 8)], expected, Tolerance);
  EXPECT_TRUE(scene.ShaderParts().empty()) << "a shader has drawn it";
}
