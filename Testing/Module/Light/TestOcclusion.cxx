// Ambient occlusion, compared with closed forms and with a reference in double precision.

#include "Module/Light/OccludedScenes.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkPlane.h>

#include <gtest/gtest.h>

#include <functional>
#include <tuple>
#include <vector>

using namespace varimarch;

TEST(Occlusion, OfAHomogeneousSlabHasItsClosedForm)
{
  for (const double opacity : { 0.1, 0.5 })
  {
    for (const double strength : { 0.3, 1.0 })
    {
      for (const double reachMm : { 3.0, 12.0 })
      {
        OccludedSlab slab(opacity, strength, reachMm);
        EXPECT_NEAR(slab.DrawnRed(), slab.ExpectedRed(), HalfByteStep)
          << opacity << ", " << strength << ", " << reachMm;
      }
    }
  }
}

TEST(Occlusion, OfMidpointsAndOnALatticeHasItsClosedFormToo)
{
  OccludedSlab slab(0.3, 0.5, 10.0);
  slab.scene.mapper->SetIntegrationRule(vtkVariationFieldVolumeMapper::Midpoint);
  EXPECT_NEAR(slab.DrawnRed(), slab.ExpectedRed(), HalfByteStep);
  EXPECT_EQ(slab.scene.mapper->GetLightMemoryBytes(), 0) << "every place is traced";
  slab.scene.mapper->SetErrorTolerance(1.0 / 64.0);
  EXPECT_NEAR(slab.DrawnRed(), slab.ExpectedRed(), 2.0 * HalfByteStep);
  EXPECT_GT(slab.scene.mapper->GetLightMemoryBytes(), 0);
}

TEST(Occlusion, OfALabelIsSeenOutsideItsOwnSurface)
{
  LabelOnNothing slab;
  slab.ExpectRed(slab.DrawnRed());
  EXPECT_TRUE(slab.scene.ShaderParts().empty()) << "a shader has drawn it";
}

// So few pixels cannot tell 99.9 % of them; the reference takes half a minute for these.
TEST(Occlusion, KeepsTheErrorToleranceInAllButSinglePixels)
{
  OccludedTorso torso(8);
  const std::vector<float> truth = torso.Truth(1e-3);
  const auto pixelsBeyond = [&](const std::vector<float>& drawn, double error)
  {
    int count = 0;
    for (std::size_t i = 0; i < truth.size(); i += 4)
    {
      count += CompareImages(drawn.data() + i, truth.data() + i, 1).largest > 255.0 * error ? 1 : 0;
    }
    return count;
  };
  const ExpectedVtkErrors warnings; // without a graphics card, shaders may end too early
  for (const double tolerance : { 1.0 / 16.0, 1.0 / 64.0 })
  {
    torso.scene.mapper->SetErrorTolerance(tolerance);
    EXPECT_LE(pixelsBeyond(torso.scene.DrawByProcessor(), tolerance), 1) << tolerance;
    EXPECT_TRUE(torso.scene.mapper->GetErrorToleranceIsKept());
    const int beyondByShaders = pixelsBeyond(torso.scene.Draw(), tolerance);
    EXPECT_TRUE(beyondByShaders <= 1 || !torso.scene.mapper->GetErrorToleranceIsKept())
      << beyondByShaders << ", " << tolerance;
  }
  torso.scene.mapper->SetAmbientOcclusion(0.0);
  EXPECT_GT(pixelsBeyond(torso.scene.DrawByProcessor(), 0.1), 10) << "occlusion is seen";
}

// In voxels of a centimetre the mapper may tell that both together miss the tolerance.
TEST(Occlusion, IsThatOfShadowedLightToo)
{
  const ExpectedVtkErrors warnings;
  OccludedTorso shadowed(24);
  shadowed.scene.mapper->ShadowsOn();
  const std::vector<float> both = shadowed.scene.DrawByProcessor();
  shadowed.scene.mapper->SetAmbientOcclusion(0.0);
  const std::vector<float> shadowsOnly = shadowed.scene.DrawByProcessor();
  double dimmed = 0.0;
  double undimmed = 0.0;
  for (std::size_t i = 0; i < both.size(); i += 4)
  {
    dimmed += both[i];
    undimmed += shadowsOnly[i];
    EXPECT_LE(both[i], shadowsOnly[i] + HalfByteStep);
    EXPECT_NEAR(both[i + 3], shadowsOnly[i + 3], 1.0 / 64.0) << "opacity stays, but for steps";
  }
  EXPECT_LT(dimmed, 0.9 * undimmed);
}

// Light that is kept from the picture before would show.
TEST(Occlusion, AfterAnyChangeIsThatOfANewVolume)
{
  const std::vector<std::tuple<const char*, std::function<void(MapperScene&)>>> changes = {
    { "camera", [](MapperScene& scene) { scene.renderer->GetActiveCamera()->Azimuth(25.0); } },
    { "strength", [](MapperScene& scene) { scene.mapper->SetAmbientOcclusion(0.8); } },
    { "reach", [](MapperScene& scene) { scene.mapper->SetAmbientOcclusionReach(40.0); } },
    { "opacity", [](MapperScene& scene) { scene.opacities->AddPoint(40.0, 0.2); } },
    { "place", [](MapperScene& scene) { scene.volume->RotateX(15.0); } },
    { "plane",
      [](MapperScene& scene)
      {
        vtkNew<vtkPlane> plane;
        plane->SetOrigin(scene.image->GetCenter());
        plane->SetNormal(1.0, 0.3, 0.2);
        scene.mapper->AddClippingPlane(plane);
      } },
    { "tolerance", [](MapperScene& scene) { scene.mapper->SetErrorTolerance(1.0 / 100.0); } },
  };
  for (const auto& [name, change] : changes)
  {
    OccludedTorso kept(8);
    const std::vector<float> before = kept.scene.DrawByProcessor();
    EXPECT_EQ(kept.scene.DrawByProcessor(), before) << name;
    change(kept.scene);
    OccludedTorso fresh(8);
    change(fresh.scene);
    const std::vector<float> after = kept.scene.DrawByProcessor();
    EXPECT_EQ(after, fresh.scene.DrawByProcessor()) << name;
    EXPECT_NE(after, before) << name << ": nothing has changed";
  }
}

TEST(Occlusion, TakesNothingWhereItIsOff)
{
  OccludedTorso torso(16);
  torso.scene.mapper->SetAmbientOcclusion(0.0);
  torso.scene.Draw();
  const std::vector<std::string> parts = torso.scene.ShaderParts();
  const vtkIdType graphicsBytes = torso.scene.mapper->GetGraphicsMemoryBytes();
  torso.scene.DrawByProcessor();
  EXPECT_EQ(torso.scene.mapper->GetLightMemoryBytes(), 0);
  torso.scene.mapper->SetAmbientOcclusion(0.5);
  torso.scene.DrawByProcessor();
  EXPECT_GT(torso.scene.mapper->GetLightMemoryBytes(), 0);
  torso.scene.mapper->SetAmbientOcclusion(0.0);
  torso.scene.DrawByProcessor();
  EXPECT_EQ(torso.scene.mapper->GetLightMemoryBytes(), 0) << "the lattice is gone";
  torso.scene.Draw();
  EXPECT_EQ(torso.scene.ShaderParts(), parts);
  EXPECT_EQ(torso.scene.mapper->GetGraphicsMemoryBytes(), graphicsBytes);
}

// A place that comes into view costs 32 rays, so that a turning image would take many times as
// long.
TEST(Occlusion, IsLeftOutWhileSomebodyInteractsAndKeptForTheStillImage)
{
  OccludedTorso torso(16);
  torso.scene.mapper->SetProcessorMarching(true);
  torso.scene.mapper->SetMaximumImageSampleDistance(1.0);
  const std::vector<float> still = torso.scene.Draw();
  const vtkIdType bytes = torso.scene.mapper->GetLightMemoryBytes();
  torso.scene.window->SetDesiredUpdateRate(20.0);
  const std::vector<float> moving = torso.scene.Draw();
  EXPECT_EQ(torso.scene.mapper->GetLightMemoryBytes(), bytes)
    << "the still image needs the lattice";
  torso.scene.window->SetDesiredUpdateRate(1e-3);
  EXPECT_EQ(torso.scene.Draw(), still);
  torso.scene.mapper->SetAmbientOcclusion(0.0);
  const std::vector<float> without = torso.scene.Draw();
  // A search in an interactive image judges steps without occlusion: a still one needs its own.
  OccludedTorso other(16);
  other.scene.mapper->SetProcessorMarching(true);
  other.scene.mapper->SetMaximumImageSampleDistance(1.0);
  other.scene.window->SetDesiredUpdateRate(1.1);
  other.scene.Draw();
  other.scene.window->SetDesiredUpdateRate(1e-3);
  EXPECT_EQ(other.scene.Draw(), still);
  const auto apart = [](const std::vector<float>& a, const std::vector<float>& b)
  { return CompareImages(a.data(), b.data(), a.size() / 4).rootMeanSquare; };
  EXPECT_LT(apart(moving, without), 0.2 * apart(still, without));
}

TEST(Occlusion, OfAVolumeThatDoesNotFitIsThatOfOneThatDoes)
{
  OccludedTorso torso(16);
  const std::vector<float> whole = torso.scene.DrawByProcessor();
  torso.scene.mapper->SetMaximumGraphicsMemory(60000);
  EXPECT_EQ(torso.scene.DrawByProcessor(), whole);
  EXPECT_LE(torso.scene.mapper->GetGraphicsMemoryBytes(), 60000);
}
