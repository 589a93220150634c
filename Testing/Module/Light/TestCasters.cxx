// Shadows of opaque geometry on volumes, compared with closed forms and with a reference that tests
// all triangles in double precision.

#include "Core/Geometry/LightCone.h"
#include "Module/Light/SlabUnderGeometry.h"
#include "Module/Scenes/CasterTruth.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkInformation.h>
#include <vtkInformationDoubleKey.h>
#include <vtkLight.h>
#include <vtkPlane.h>
#include <vtkProperty.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace varimarch;

namespace
{

// Red of the slab where depths from one to another are lit: the eye sees exp(-sigma z) of what
// exp(-sigma z / cosine) of the light excites at depth z.
double RedBetween(double from, double to)
{
  const double extinction = -std::log1p(-SlabUnderGeometry::OpacityPerMm);
  const double both = extinction * (1.0 + 1.0 / TowardsSun.z);
  return SlabUnderGeometry::Red * TowardsSun.z * extinction / both *
    (std::exp(-both * from) - std::exp(-both * to));
}

// The depth below the slab's upper face at which the edge x of a sheet lets the sun's rays meet the
// line of sight x = 0.
double DepthOfEdge(double x, double height)
{
  return SlabUnderGeometry::ThicknessMm - height + x * TowardsSun.z / TowardsSun.x;
}

}

TEST(Casters, OfASheetEndAtTheirClosedForm)
{
  for (const double depth : { 0.3, 1.0, 3.37 })
  {
    const double height = 20.0;
    const double edge =
      (depth + height - SlabUnderGeometry::ThicknessMm) * TowardsSun.x / TowardsSun.z;
    ASSERT_NEAR(DepthOfEdge(edge, height), depth, 1e-9);
    SlabUnderGeometry left;
    left.AddSun();
    left.scene.renderer->AddActor(HiddenActor(Sheet(edge, 90.0, height)));
    EXPECT_NEAR(left.DrawnRed(), RedBetween(0.0, depth), HalfByteStep) << depth;
    SlabUnderGeometry right;
    right.AddSun();
    right.scene.renderer->AddActor(HiddenActor(Sheet(-90.0, edge, height)));
    EXPECT_NEAR(right.DrawnRed(), RedBetween(depth, SlabUnderGeometry::ThicknessMm), HalfByteStep)
      << depth;
  }
}

// The upper half of the slab, above z = 4, is cut away.
TEST(Casters, ShadeWhatClippingPlanesLeave)
{
  constexpr double Depth = 1.5;
  const double edge = (20.0 - 4.0 + Depth) * TowardsSun.x / TowardsSun.z;
  SlabUnderGeometry slab;
  slab.AddSun();
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 4.0);
  plane->SetNormal(0.0, 0.0, -1.0);
  slab.scene.mapper->AddClippingPlane(plane);
  slab.scene.renderer->AddActor(HiddenActor(Sheet(edge, 90.0, 20.0)));
  EXPECT_NEAR(slab.DrawnRed(), RedBetween(0.0, Depth), HalfByteStep);
}

// Floats near 200 m are a hundredth of a millimetre apart.
TEST(Casters, AreAsExactFarFromTheOriginOfTheWorld)
{
  const glm::dvec3 far(200000.123, -100000.456, 0.0);
  SlabUnderGeometry slab;
  slab.AddSun();
  slab.scene.volume->SetPosition(far.x, far.y, far.z);
  slab.scene.LookDown(far, 0.5);
  const auto sheet = HiddenActor(Sheet(9.75, 90.0, 20.0));
  sheet->SetPosition(far.x, far.y, far.z);
  slab.scene.renderer->AddActor(sheet);
  EXPECT_NEAR(slab.DrawnRed(), RedBetween(0.0, DepthOfEdge(9.75, 20.0)), HalfByteStep);
}

TEST(Casters, AreTheSameForShaders)
{
  SlabUnderGeometry slab;
  slab.AddSun();
  slab.scene.renderer->AddActor(HiddenActor(Sheet(9.75, 90.0, 20.0)));
  const ExpectedVtkErrors warningOfShaders; // their steps are longer than asked for on llvmpipe
  const std::vector<float> drawn = slab.scene.Draw();
  EXPECT_TRUE(slab.scene.UsesShaderPart("Casters/Triangles.glsl"));
  EXPECT_NEAR(
    drawn[4 * (drawn.size() / 8)], RedBetween(0.0, DepthOfEdge(9.75, 20.0)), HalfByteStep);
}

TEST(Casters, TakeLightOnlyBetweenALampAndThePlace)
{
  for (const double height : { 20.0, 40.0 })
  {
    SlabUnderGeometry slab;
    vtkLight* const lamp = AddLight(slab.scene.renderer, { 0.0, 0.0, 30.0 }, glm::dvec3(0.0));
    lamp->PositionalOn();
    lamp->SetConeAngle(40.0);
    const double lit = slab.DrawnRed();
    EXPECT_GT(lit, 0.1);
    slab.scene.renderer->AddActor(HiddenActor(Sheet(-10.0, 10.0, height)));
    EXPECT_NEAR(slab.DrawnRed(), height < 30.0 ? 0.0 : lit, 1e-6) << height;
  }
}

// A sheet over x > 0.5 mm hides the directions of the cone on that side.
TEST(Casters, HideAPartOfASoftLight)
{
  constexpr double SoftnessDegrees = 20.0;
  double expected = 0.0;
  for (const auto& [direction, weight] :
    DirectionsInCone({ 0.0, 0.0, 1.0 }, glm::radians(SoftnessDegrees)))
  {
    const double extinction = -std::log1p(-SlabUnderGeometry::OpacityPerMm);
    const double both = extinction * (1.0 + 1.0 / direction.z);
    expected += direction.x > 0.01 ? 0.0
                                   : weight * SlabUnderGeometry::Red * extinction / both *
        (1.0 - std::exp(-both * SlabUnderGeometry::ThicknessMm));
  }
  SlabUnderGeometry slab;
  AddLight(slab.scene.renderer, { 0.0, 0.0, 100.0 }, glm::dvec3(0.0))
    ->GetInformation()
    ->Set(vtkVariationFieldVolumeMapper::LIGHT_SOFTNESS(), SoftnessDegrees);
  slab.scene.renderer->AddActor(HiddenActor(Sheet(0.5, 90.0, 40.0)));
  EXPECT_NEAR(slab.DrawnRed(), expected, HalfByteStep);
  const ExpectedVtkErrors warningOfShaders; // their steps are longer than asked for on llvmpipe
  const std::vector<float> drawn = slab.scene.Draw();
  EXPECT_NEAR(drawn[4 * (drawn.size() / 8)], expected, 2.0 * HalfByteStep);
}

TEST(Casters, AreAsStrongAsShadowsAre)
{
  SlabUnderGeometry slab;
  slab.AddSun();
  slab.scene.mapper->SetShadowStrength(0.0);
  const double unshadowed = slab.DrawnRed();
  slab.scene.mapper->SetShadowStrength(0.4);
  slab.scene.renderer->AddActor(HiddenActor(Sheet(-90.0, 90.0, 20.0)));
  EXPECT_NEAR(slab.DrawnRed(), 0.6 * unshadowed, 1e-3);
}

TEST(Casters, TakeShaderAndMemoryOnlyWhereTheyAre)
{
  SlabUnderGeometry slab;
  slab.AddSun();
  const ExpectedVtkErrors warningOfShaders;
  slab.scene.Draw();
  EXPECT_TRUE(slab.scene.UsesShaderPart("Casters/None.glsl"));
  const auto actor = HiddenActor(Sheet(-90.0, 90.0, 20.0));
  actor->GetProperty()->SetRepresentationToWireframe();
  slab.scene.renderer->AddActor(actor);
  slab.scene.Draw();
  EXPECT_TRUE(slab.scene.UsesShaderPart("Casters/None.glsl"));
  const vtkIdType bytes = slab.scene.mapper->GetGraphicsMemoryBytes();
  actor->GetProperty()->SetRepresentationToSurface();
  slab.scene.Draw();
  EXPECT_TRUE(slab.scene.UsesShaderPart("Casters/Triangles.glsl"));
  EXPECT_GT(slab.scene.mapper->GetGraphicsMemoryBytes(), bytes);
  slab.scene.mapper->ShadowsOff();
  slab.scene.Draw();
  EXPECT_FALSE(slab.scene.UsesShaderPart("Casters/Triangles.glsl"));
  EXPECT_EQ(slab.scene.mapper->GetGraphicsMemoryBytes(), bytes);
}

namespace
{

// A turned torso under a sun and a lamp, with a ball in the light of each.
class TorsoUnderBalls
{
public:
  explicit TorsoUnderBalls(int size)
    : scene(SmallTorso(), size)
  {
    CastShadowsOfSunAndLamp(this->scene);
    const glm::dvec3 center = glm::make_vec3(this->scene.volume->GetCenter());
    const double length = this->scene.volume->GetLength();
    const glm::dvec3 toSun = glm::normalize(glm::dvec3(1.0, -0.5, 2.0));
    this->AddBall(center + 0.55 * length * toSun, 0.12 * length);
    this->AddBall(glm::mix(center, glm::dvec3(-60.0, -250.0, 30.0), 0.6), 0.05 * length);
  }

  void AddBall(glm::dvec3 center, double radius)
  {
    const auto ball = UndrawnActor::Of(Ball(glm::value_ptr(center), radius)->GetMapper());
    this->scene.renderer->AddActor(ball);
    this->balls.push_back(ball);
  }

  std::vector<float> Truth(double tolerance)
  {
    return this->scene.TruthOf(MaterialInShadowsOf(this->scene, this->balls, tolerance), tolerance);
  }

  MapperScene scene;
  std::vector<vtkActor*> balls;
};

}

TEST(Casters, KeepTheErrorTolerance)
{
  TorsoUnderBalls torso(16);
  const std::vector<float> truth = torso.Truth(4e-4);
  const auto errorOf = [&](const std::vector<float>& drawn)
  { return CompareImages(drawn.data(), truth.data(), truth.size() / 4).percentile999; };
  for (const double tolerance : { 1.0 / 16.0, 1.0 / 64.0, 1.0 / 255.0 })
  {
    torso.scene.mapper->SetErrorTolerance(tolerance);
    EXPECT_LT(errorOf(torso.scene.DrawByProcessor()), 255.0 * tolerance) << tolerance;
  }
  for (vtkActor* ball : torso.balls)
  {
    ball->VisibilityOff();
  }
  EXPECT_GT(errorOf(torso.scene.DrawByProcessor()), 10.0) << "their shadows are seen";
}

// OpenGL without a graphics card ends the shader of shorter steps.
TEST(Casters, OfShadersComeNearerTheTruthWithShorterSteps)
{
  TorsoUnderBalls torso(16);
  const std::vector<float> truth = torso.Truth(1e-3);
  torso.scene.mapper->AutoAdjustSampleDistancesOff();
  const auto errorAt = [&](float sampleDistanceMm)
  {
    torso.scene.mapper->SetSampleDistance(sampleDistanceMm);
    const std::vector<float> drawn = torso.scene.Draw();
    EXPECT_TRUE(torso.scene.UsesShaderPart("Casters/Triangles.glsl"));
    return CompareImages(drawn.data(), truth.data(), truth.size() / 4).percentile999;
  };
  const ExpectedVtkErrors warningOfShaders;
  EXPECT_GT(errorAt(6.0f), 20.0);
  EXPECT_LT(errorAt(3.0f), 8.0);
}

TEST(Casters, OfShadersWithoutACardKeepNoTolerance)
{
  SlabUnderGeometry slab;
  slab.AddSun();
  slab.scene.mapper->SetErrorTolerance(1.0 / 16.0);
  slab.scene.mapper->AutoAdjustSampleDistancesOn();
  slab.scene.renderer->AddActor(HiddenActor(Sheet(9.75, 90.0, 20.0)));
  const ExpectedVtkErrors messages;
  slab.scene.Draw();
  EXPECT_NE(messages.Text().find("shadows may be wrong"), std::string::npos) << messages.Text();
  slab.scene.DrawByProcessor();
  EXPECT_TRUE(slab.scene.mapper->GetErrorToleranceIsKept());
}

// Geometry is not part of the light that lattices keep.
TEST(Casters, MoveWithoutNewLattices)
{
  TorsoUnderBalls kept(48);
  const auto prepare = [](MapperScene& scene)
  {
    scene.opacities->RemoveAllPoints();
    scene.opacities->AddPoint(-200.0, 0.0);
    scene.opacities->AddPoint(300.0, 0.1);
    scene.mapper->SetErrorTolerance(1.0 / 64.0);
  };
  prepare(kept.scene);
  const std::vector<float> before = kept.scene.DrawByProcessor();
  const int builds = kept.scene.mapper->GetLightLatticeBuilds();
  EXPECT_GT(builds, 0);
  EXPECT_EQ(kept.scene.DrawByProcessor(), before);
  kept.balls.front()->AddPosition(10.0, 5.0, 0.0);
  const std::vector<float> after = kept.scene.DrawByProcessor();
  EXPECT_EQ(kept.scene.mapper->GetLightLatticeBuilds(), builds);
  EXPECT_NE(after, before);
  const std::vector<float> atRest = kept.scene.DrawByProcessor(); // with steps of its own
  TorsoUnderBalls fresh(48);
  prepare(fresh.scene);
  fresh.balls.front()->AddPosition(10.0, 5.0, 0.0);
  EXPECT_EQ(atRest, fresh.scene.DrawByProcessor());
}
