// Shadows that a slab casts on itself, compared with closed forms.

#include "Core/Geometry/LightCone.h"
#include "Module/Scenes/SlabScene.h"
#include "Module/Scenes/UsualSettings.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkInformation.h>
#include <vtkInformationDoubleKey.h>
#include <vtkLight.h>
#include <vtkPlane.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace varimarch;

namespace
{

constexpr double Red = 0.8;
constexpr double SlabMm = 8.0;

// A slab whose light is diffuse.
class Slab
{
public:
  explicit Slab(double opacityPerMm)
    : scene(opacityPerMm, Red)
  {
    this->scene.LightDiffusely();
  }

  vtkLight* AddLight(glm::dvec3 position, glm::dvec3 focus = glm::dvec3(0.0))
  {
    return ::AddLight(this->scene.renderer, position, focus);
  }

  double DrawnRed() { return this->scene.MiddlePixel()[0]; }

  SlabScene scene;
};

// The light of a slab seen along its normal, lit at an angle: the eye sees exp(-sigma z) of what
// exp(-sigma z / cosine) of the light excites at depth z.
double RedOfSlab(double opacityPerMm, double cosine)
{
  const double extinction = -std::log1p(-opacityPerMm);
  const double both = extinction * (1.0 + 1.0 / cosine);
  return Red * cosine * extinction / both * (1.0 - std::exp(-both * SlabMm));
}

}

TEST(Shadows, OfAHomogeneousSlabHaveTheirClosedForm)
{
  for (const double opacity : { 0.05, 0.3 })
  {
    for (const double cosine : { 1.0, 0.8, 0.4 })
    {
      Slab slab(opacity);
      slab.AddLight(100.0 * glm::dvec3(std::sqrt(1.0 - cosine * cosine), 0.0, cosine));
      EXPECT_NEAR(slab.DrawnRed(), RedOfSlab(opacity, cosine), HalfByteStep)
        << opacity << ", " << cosine;
    }
  }
}

TEST(Shadows, AreAsStrongAsTheyAreAskedFor)
{
  constexpr double Opacity = 0.3;
  constexpr double Cosine = 0.6;
  const double unshadowed = Red * Cosine * (1.0 - std::pow(1.0 - Opacity, SlabMm));
  for (const double strength : { 0.0, 0.4, 1.0 })
  {
    Slab slab(Opacity);
    slab.AddLight({ 80.0, 0.0, 100.0 * Cosine });
    slab.scene.mapper->SetShadowStrength(strength);
    EXPECT_NEAR(slab.DrawnRed(),
      (1.0 - strength) * unshadowed + strength * RedOfSlab(Opacity, Cosine), HalfByteStep)
      << strength;
  }
}

TEST(Shadows, WithoutStrengthTakeNothing)
{
  Slab slab(0.1);
  slab.AddLight({ 80.0, 0.0, 60.0 });
  slab.scene.mapper->SetErrorTolerance(1.0 / 64.0); // without one there is no lattice
  slab.scene.DrawByProcessor();
  EXPECT_GT(slab.scene.mapper->GetLightMemoryBytes(), 0);
  slab.scene.mapper->SetShadowStrength(0.0);
  slab.scene.DrawByProcessor();
  EXPECT_EQ(slab.scene.mapper->GetLightMemoryBytes(), 0);
  slab.scene.Draw();
  EXPECT_TRUE(slab.scene.UsesShaderPart("Reach/None.glsl"));
}

TEST(Shadows, OfASoftLightAreTheMeanOverItsCone)
{
  constexpr double SoftnessDegrees = 25.0;
  const glm::dvec3 towards(0.8, 0.0, 0.6);
  double expected = 0.0;
  for (const auto& [direction, weight] : DirectionsInCone(towards, glm::radians(SoftnessDegrees)))
  {
    // Surfaces face the middle of the light.
    expected += weight * RedOfSlab(0.3, direction.z) * towards.z / direction.z;
  }
  const ExpectedVtkErrors warningOfShaders; // their steps are longer than asked for on llvmpipe
  for (const double tolerance : { 0.0, 1.0 / 64.0 })
  {
    Slab slab(0.3);
    slab.scene.mapper->SetErrorTolerance(tolerance);
    slab.AddLight(100.0 * towards)
      ->GetInformation()
      ->Set(vtkVariationFieldVolumeMapper::LIGHT_SOFTNESS(), SoftnessDegrees);
    EXPECT_NEAR(slab.DrawnRed(), expected, HalfByteStep + tolerance) << tolerance;
  }
  EXPECT_GT(std::abs(expected - RedOfSlab(0.3, towards.z)), 0.005);
}

TEST(Shadows, TakeAConeOnlyForSoftLights)
{
  const ExpectedVtkErrors warningOfShaders; // their steps are longer than asked for on llvmpipe
  Slab slab(0.3);
  vtkInformation* const light = slab.AddLight({ 80.0, 0.0, 60.0 })->GetInformation();
  slab.scene.Draw();
  EXPECT_TRUE(slab.scene.UsesShaderPart("Cone/None.glsl"));
  light->Set(vtkVariationFieldVolumeMapper::LIGHT_SOFTNESS(), 25.0);
  slab.scene.Draw();
  EXPECT_TRUE(slab.scene.UsesShaderPart("Cone/Disc.glsl"));
  light->Set(vtkVariationFieldVolumeMapper::LIGHT_SOFTNESS(), 0.0);
  slab.scene.Draw();
  EXPECT_TRUE(slab.scene.UsesShaderPart("Cone/None.glsl"));
  slab.scene.mapper->ShadowsOff();
  slab.scene.Draw();
  EXPECT_FALSE(slab.scene.UsesShaderPart("Cone/None.glsl")) << "nothing casts shadows";
}

TEST(Shadows, OfMidpointsHaveTheirClosedFormToo)
{
  Slab slab(0.3);
  slab.scene.mapper->SetIntegrationRule(vtkVariationFieldVolumeMapper::Midpoint);
  slab.AddLight({ 60.0, 0.0, 80.0 });
  EXPECT_NEAR(slab.DrawnRed(), RedOfSlab(0.3, 0.8), HalfByteStep);
}

TEST(Shadows, OfTwoHalfLightsAreThoseOfOneWhole)
{
  Slab whole(0.3);
  whole.AddLight({ 30.0, 20.0, 40.0 });
  Slab halves(0.3);
  halves.AddLight({ 30.0, 20.0, 40.0 })->SetIntensity(0.5);
  halves.AddLight({ 30.0, 20.0, 40.0 })->SetIntensity(0.5);
  EXPECT_NEAR(halves.DrawnRed(), whole.DrawnRed(), 1e-3)
    << "two rays have longer segments on llvmpipe";
}

TEST(Shadows, EndAtALightInsideTheVolume)
{
  // The light is in the middle of the slab, so that only what lies between it and a sample counts.
  Slab slab(0.2);
  vtkLight* const lamp = slab.AddLight({ 0.0, 0.0, 4.0 });
  lamp->PositionalOn();
  lamp->SetConeAngle(180.0);
  const double extinction = -std::log1p(-0.2);
  double red = 0.0;
  constexpr int Parts = 100000;
  for (int i = 0; i < Parts; ++i)
  {
    const double depth = (i + 0.5) * SlabMm / Parts;
    red += Red * extinction * SlabMm / Parts *
      std::exp(-extinction * depth - extinction * std::abs(depth - 4.0));
  }
  EXPECT_NEAR(slab.DrawnRed(), red, HalfByteStep);
}

TEST(Shadows, AreNotCastByClippedOrCroppedParts)
{
  // The eye looks down onto the slab's lower half. What is above it is cut away.
  const double opacity = 0.3;
  const double extinction = -std::log1p(-opacity);
  const double expected = Red * 0.5 * (1.0 - std::exp(-2.0 * extinction * 4.0));
  Slab clipped(opacity);
  clipped.AddLight({ 0.0, 0.0, 100.0 });
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 4.0);
  plane->SetNormal(0.0, 0.0, -1.0);
  clipped.scene.mapper->AddClippingPlane(plane);
  EXPECT_NEAR(clipped.DrawnRed(), expected, HalfByteStep);
  Slab cropped(opacity);
  cropped.AddLight({ 0.0, 0.0, 100.0 });
  cropped.scene.mapper->CroppingOn();
  cropped.scene.mapper->SetCroppingRegionPlanes(-200.0, 200.0, -200.0, 200.0, -1.0, 4.0);
  cropped.scene.mapper->SetCroppingRegionFlagsToSubVolume();
  EXPECT_NEAR(cropped.DrawnRed(), expected, 2.0 * HalfByteStep) << "a segment may cross the plane";
}

TEST(Shadows, AreNotCastByWhatAMaskHides)
{
  Slab slab(0.3);
  slab.AddLight({ 0.0, 0.0, 100.0 });
  vtkNew<vtkImageData> mask;
  mask->CopyStructure(slab.scene.image);
  mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* const voxels = static_cast<unsigned char*>(mask->GetScalarPointer());
  for (int i = 0; i < 9 * 9 * 9; ++i)
  {
    voxels[i] = i / (9 * 9) < 5 ? 255 : 0; // up to z = 4.5
  }
  slab.scene.mapper->SetMaskInput(mask);
  slab.scene.mapper->SetMaskTypeToBinary();
  const double extinction = -std::log1p(-0.3);
  // The shader on llvmpipe has long steps in so wide a slab.
  const std::vector<float> drawn = slab.scene.DrawByProcessor();
  EXPECT_NEAR(drawn[4 * (drawn.size() / 8)], Red * 0.5 * (1.0 - std::exp(-9.0 * extinction)),
    2.0 * HalfByteStep)
    << "a segment may cross the faces of the mask";
}
