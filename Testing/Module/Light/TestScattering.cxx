// Light that a slab and a sheet scatter, compared with closed forms and the reference.

#include "Module/Scenes/ReferenceMaterials.h"
#include "Module/Scenes/SlabScene.h"
#include "Module/Scenes/UsualSettings.h"

#include <vtkInformation.h>
#include <vtkInformationDoubleKey.h>
#include <vtkLight.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

using namespace varimarch;

namespace
{

constexpr double SlabRed = 0.8;
constexpr double SlabDepthMm = 8.0;
constexpr double SlabOpacity = 0.2;
constexpr double LightCosine = 0.6; // between the light and the eye, which looks down

/// How light is scattered, and what dims it.
struct Scattered
{
  double blending;
  double anisotropy;
  double reach;
  double shadows; ///< their strength
};

void LightSlab(MapperScene& scene, const Scattered& light)
{
  vtkVolumeProperty* const property = scene.volume->GetProperty();
  property->ShadeOn();
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(0.0);
  scene.renderer->AutomaticLightCreationOff();
  scene.renderer->RemoveAllLights();
  AddLight(scene.renderer,
    100.0 * glm::dvec3(std::sqrt(1.0 - LightCosine * LightCosine), 0.0, LightCosine),
    glm::dvec3(0.0));
  scene.mapper->SetVolumetricScatteringBlending(light.blending);
  scene.mapper->SetScatteringAnisotropy(light.anisotropy);
  scene.mapper->SetGlobalIlluminationReach(light.reach);
  scene.mapper->SetShadows(light.shadows > 0.0);
  scene.mapper->SetShadowStrength(light.shadows);
}

// A sheet in the odd layer of voxels in the middle, at right angles to z.
constexpr unsigned char SheetValue = 200;

vtkSmartPointer<vtkImageData> ThinSheet()
{
  constexpr int Side = 15;
  constexpr int Layer = Side / 2;
  static_assert(Layer % 2 == 1, "nodes of the lattice lie in even layers");
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Side, Side, Side);
  image->SetOrigin(-Layer, -Layer, -Layer);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* const voxels = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < Side * Side * Side; ++i)
  {
    voxels[i] = i / (Side * Side) == Layer ? SheetValue : 0;
  }
  return image;
}

// The slab as both marchers draw it.
double DrawnRed(const Scattered& light, double errorTolerance = 0.0)
{
  SlabScene scene(SlabOpacity, SlabRed);
  LightSlab(scene, light);
  scene.mapper->SetErrorTolerance(errorTolerance);
  return scene.MiddlePixel()[0];
}

// The part of a light that a slab sends, undimmed or dimmed on its way in.
double PartOfSlab(bool isDimmed)
{
  const double extinction = -std::log1p(-SlabOpacity);
  const double both = extinction * (isDimmed ? 1.0 + 1.0 / LightCosine : 1.0);
  return extinction / both * (1.0 - std::exp(-both * SlabDepthMm));
}

double Phase(double anisotropy)
{
  const double squared = anisotropy * anisotropy;
  return (1.0 - squared) / std::pow(1.0 + squared + 2.0 * anisotropy * LightCosine, 1.5);
}

double ExpectedRed(const Scattered& light)
{
  const double part = std::min(light.blending, 1.0);
  const double scattered =
    part * Phase(light.anisotropy) * PartOfSlab(light.shadows > 0.0 || light.reach == 1.0);
  const double onSurfaces =
    (1.0 - light.shadows) * PartOfSlab(false) + light.shadows * PartOfSlab(true);
  return SlabRed * (scattered + (1.0 - part) * LightCosine * onSurfaces);
}

}

TEST(Scattering, OfAHomogeneousSlabHasItsClosedForm)
{
  for (const Scattered& light : { Scattered{ 1.0, 0.0, 0.0, 0.0 }, Scattered{ 1.0, 0.5, 1.0, 0.0 },
         Scattered{ 0.4, -0.3, 1.0, 0.0 }, Scattered{ 0.4, -0.3, 0.0, 1.0 },
         Scattered{ 0.4, -0.3, 0.0, 0.5 }, Scattered{ 2.0, -0.6, 1.0, 0.0 } })
  {
    EXPECT_NEAR(DrawnRed(light), ExpectedRed(light), HalfByteStep)
      << light.blending << ", " << light.anisotropy << ", " << light.reach << ", " << light.shadows;
  }
}

TEST(Scattering, KeepsAnErrorTolerance)
{
  const Scattered light{ 0.7, 0.4, 1.0, 0.0 };
  EXPECT_NEAR(DrawnRed(light, 1.0 / 64.0), ExpectedRed(light), 1.0 / 64.0);
}

// The sheet lies between the nodes of a lattice of light, and light comes along it: no node tells
// how much light the sheet takes.
TEST(Scattering, OfASheetThinnerThanACellOfTheLatticeKeepsTheErrorTolerance)
{
  constexpr double Tolerance = 1.0 / 64.0;
  MapperScene scene(ThinSheet(), 16);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(0.0, 0.0);
  scene.opacities->AddPoint(SheetValue, 0.3);
  scene.LookDown({ 0.0, 0.0, 0.0 }, 7.0);
  scene.mapper->SetErrorTolerance(Tolerance);
  for (const double softness : { 0.0, 3.0 })
  {
    LightSlab(scene, { 1.0, 0.0, 0.0, 1.0 });
    scene.renderer->RemoveAllLights();
    vtkLight* const light = AddLight(scene.renderer, { 100.0, 20.0, 0.0 }, glm::dvec3(0.0));
    light->GetInformation()->Set(vtkVariationFieldVolumeMapper::LIGHT_SOFTNESS(), softness);
    const std::vector<float> truth = scene.TruthOf(MaterialInOwnShadows(scene, 1e-3), 1e-3);
    const std::vector<float> drawn = scene.DrawByProcessor();
    EXPECT_GT(scene.mapper->GetLightMemoryBytes(), 0) << "there is a lattice";
    EXPECT_LT(
      CompareImages(drawn.data(), truth.data(), truth.size() / 4).percentile999, 255.0 * Tolerance)
      << softness;
  }
}

TEST(Scattering, IsDimmedWithinItsReachOnly)
{
  // The slab's light comes from within a diagonal; a longer reach dims more of it.
  double last = SlabRed;
  for (const double reach : { 0.0, 0.02, 0.1, 1.0 })
  {
    const double red = DrawnRed({ 1.0, 0.0, reach, 0.0 });
    EXPECT_LT(red, last - 0.02) << reach;
    last = red;
  }
}

TEST(Scattering, OfALightAtTheEyeComesBack)
{
  SlabScene scene(SlabOpacity, SlabRed);
  vtkVolumeProperty* const property = scene.volume->GetProperty();
  property->ShadeOn();
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  scene.mapper->SetVolumetricScatteringBlending(1.0);
  scene.mapper->SetScatteringAnisotropy(-0.05);
  scene.mapper->ShadowsOn();
  const double back = (1.0 - 0.0025) / std::pow(1.0 + 0.0025 - 0.1, 1.5);
  EXPECT_NEAR(scene.MiddlePixel()[0], SlabRed * back * PartOfSlab(false), HalfByteStep);
  EXPECT_TRUE(scene.UsesShaderPart("Reach/None.glsl")) << "nothing dims a light at the eye";
}

TEST(Scattering, TakesNoShaderWhereItIsOff)
{
  SlabScene scene(SlabOpacity, SlabRed);
  LightSlab(scene, { 0.0, 0.5, 1.0, 0.0 });
  const std::vector<float> drawn = scene.Draw();
  EXPECT_TRUE(scene.UsesShaderPart("Scatter/None.glsl"));
  EXPECT_TRUE(scene.UsesShaderPart("Reach/None.glsl"));
  const vtkIdType bytes = scene.mapper->GetGraphicsMemoryBytes();
  LightSlab(scene, { 0.0, 0.0, 0.0, 0.0 });
  EXPECT_EQ(scene.Draw(), drawn) << "anisotropy and reach are those of scattered light";
  LightSlab(scene, { 1.0, 0.5, 1.0, 0.0 });
  scene.Draw();
  EXPECT_TRUE(scene.UsesShaderPart("Scatter/HenyeyGreenstein.glsl"));
  EXPECT_TRUE(scene.UsesShaderPart("Reach/ShadowRays.glsl"));
  EXPECT_EQ(scene.mapper->GetGraphicsMemoryBytes(), bytes) << "it needs no texture";
}

TEST(Scattering, KeepsNoLatticeWhereNothingDimsIt)
{
  SlabScene scene(SlabOpacity, SlabRed);
  scene.mapper->SetErrorTolerance(1.0 / 64.0); // without one there is no lattice
  const auto latticeBytes = [&](const Scattered& light)
  {
    LightSlab(scene, light);
    scene.DrawByProcessor();
    return scene.mapper->GetLightMemoryBytes();
  };
  EXPECT_GT(latticeBytes({ 1.0, 0.5, 1.0, 0.0 }), 0);
  EXPECT_EQ(latticeBytes({ 1.0, 0.5, 0.0, 0.0 }), 0);
  EXPECT_EQ(latticeBytes({ 0.0, 0.5, 1.0, 0.0 }), 0);
}
