// Ambient occlusion, compared with closed forms and with a reference in double precision.

#include "Core/Geometry/ScalarGrid.h"
#include "Core/Reference/SkyVisibility.h"
#include "Frame/PropertyTransferFunction.h"
#include "Frame/VolumeGeometry.h"
#include "Module/ReferenceMaterials.h"
#include "Module/SlabScene.h"
#include "Module/UsualSettings.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkPlane.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <tuple>
#include <vector>

using namespace varimarch;

namespace
{

constexpr double ColorRed = 0.8;
constexpr double OccludedMm = 8.0;

// A slab with ambient occlusion, and its closed form.
class OccludedSlab
{
public:
  OccludedSlab(double opacityPerMm, double strength, double reachMm)
    : extinction(-std::log1p(-opacityPerMm))
    , strength(strength)
    , reachMm(reachMm)
    , scene(opacityPerMm, ColorRed)
  {
    this->scene.mapper->SetAmbientOcclusion(strength);
    this->scene.mapper->SetAmbientOcclusionReach(reachMm);
  }

  double DrawnRed()
  {
    const std::vector<float> drawn = this->scene.DrawByProcessor();
    return drawn[4 * (drawn.size() / 8)];
  }

  // Each depth emits what it keeps of the light that arrives two voxels above it.
  double ExpectedRed() const
  {
    constexpr int Parts = 20000;
    constexpr double PartMm = OccludedMm / Parts;
    constexpr double VoxelMm = 1.0;
    double red = 0.0;
    for (int i = 0; i < Parts; ++i)
    {
      const double depthMm = (i + 0.5) * PartMm;
      red += ColorRed * this->extinction * PartMm * std::exp(-this->extinction * depthMm) *
        KeptLight(this->VisibilityAt(depthMm - 2.0 * VoxelMm), this->strength);
    }
    return red;
  }

  double extinction;
  double strength;
  double reachMm;
  SlabScene scene;

private:
  double VisibilityAt(double depthMm) const
  {
    double sum = 0.0;
    for (const auto& [direction, weight] : SphereQuadrature())
    {
      // The part of the way to the reach that is inside the slab.
      const double end = depthMm - direction.z * this->reachMm;
      const auto inside = [](double depth) { return std::clamp(depth, 0.0, OccludedMm); };
      const double pathMm = std::abs(inside(end) - inside(depthMm)) / std::abs(direction.z);
      sum += weight * std::exp(-this->extinction * pathMm);
    }
    return sum;
  }
};

// A turned torso under a sun and a lamp.
class OccludedTorso
{
public:
  explicit OccludedTorso(int size)
    : scene(SmallTorso(), size)
    , geometry(VolumeGeometryOf(this->scene.image, this->scene.volume))
    , voxels(static_cast<const short*>(this->scene.image->GetScalarPointer()),
        static_cast<const short*>(this->scene.image->GetScalarPointer()) +
          this->scene.image->GetNumberOfPoints())
    , grid(this->voxels.data(), this->geometry.dimensions)
  {
    this->scene.volume->GetProperty()->ShadeOn();
    this->scene.mapper->SetAmbientOcclusion(0.5);
    this->scene.mapper->SetErrorTolerance(1.0 / 64.0);
    UseSunAndLamp(this->scene.renderer);
  }

  std::vector<float> Truth(double tolerance)
  {
    return this->scene.TruthOf(OccludedMaterial(this->scene, tolerance), tolerance);
  }

  MapperScene scene;

private:
  glm::dvec3 SeenFrom(glm::dvec3 positionGrid, const TransferFunction& look) const
  {
    const double value = this->grid.Value(positionGrid);
    const glm::dvec3 gradient = this->grid.Gradient(positionGrid);
    const double perVoxel = glm::length(gradient);
    return OutsideOf(positionGrid, gradient,
      look.Extinction(value + perVoxel) < look.Extinction(value - perVoxel));
  }

  VolumeGeometry geometry;
  std::vector<short> voxels;
  ScalarGrid<short> grid;
};

}

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
  for (const double tolerance : { 1.0 / 16.0, 1.0 / 64.0 })
  {
    torso.scene.mapper->SetErrorTolerance(tolerance);
    const std::vector<float> drawn = torso.scene.DrawByProcessor();
    EXPECT_LE(pixelsBeyond(drawn, tolerance), 1) << tolerance;
    EXPECT_EQ(pixelsBeyond(drawn, 1.25 * tolerance), 0) << tolerance;
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
    EXPECT_NEAR(both[i + 3], shadowsOnly[i + 3], 2.0 * HalfByteStep) << "opacity stays";
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
    OccludedTorso kept(24);
    const std::vector<float> before = kept.scene.DrawByProcessor();
    EXPECT_EQ(kept.scene.DrawByProcessor(), before) << name;
    change(kept.scene);
    OccludedTorso fresh(24);
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

TEST(Occlusion, ByShadersIsLeftOutWithASentence)
{
  OccludedTorso torso(16);
  torso.scene.mapper->SetErrorTolerance(0.0);
  ExpectedVtkErrors warnings;
  const std::vector<float> drawn = torso.scene.Draw();
  EXPECT_NE(warnings.Text().find("has no ambient occlusion"), std::string::npos) << warnings.Text();
  torso.scene.mapper->SetAmbientOcclusion(0.0);
  EXPECT_EQ(torso.scene.Draw(), drawn);
}
