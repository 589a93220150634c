// Shadows and ambient occlusion of label maps and of voxels without interpolation, compared with a
// reference in double precision.

#include "Module/Scenes/LabelledTorso.h"
#include "Module/Scenes/ReferenceMaterials.h"
#include "Module/Scenes/SlabScene.h"
#include "Module/Scenes/UsualSettings.h"
#include "Support/ExpectedVtkErrors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace varimarch;

namespace
{

constexpr double ReferenceTolerance = 2e-3;
constexpr double UsualTolerance = 1.0 / 64.0;

// A labelled torso under a sun and a lamp.
class LitTorso : public LabelledTorso
{
public:
  explicit LitTorso(int pictureSide)
    : LabelledTorso(pictureSide)
  {
    this->scene.volume->GetProperty()->ShadeOn();
    this->scene.mapper->SetErrorTolerance(UsualTolerance);
    UseSunAndLamp(this->scene.renderer);
  }

  void RemoveLabels() { this->scene.mapper->SetMaskInput(nullptr); }
  void UseBoxes() { this->scene.volume->GetProperty()->SetInterpolationTypeToNearest(); }

  UnlitLook LookOfLabels(const UnlitLook& ofVoxels)
  {
    UnlitLook look = ofVoxels;
    look.properties = [this, ofVoxels](glm::dvec3 position, double value)
    { return this->LookAt(position, value, ofVoxels.gradient(position)); };
    return look;
  }

  // The error of the processor's image of a look.
  ImageError ErrorOf(const UnlitLook& look)
  {
    const std::vector<float> truth = this->scene.TruthOf(
      DimmedMaterial(this->scene, look, ReferenceTolerance), ReferenceTolerance);
    const std::vector<float> drawn = this->scene.DrawByProcessor();
    EXPECT_TRUE(this->scene.ShaderParts().empty()) << "packets march";
    return CompareImages(drawn.data(), truth.data(), truth.size() / 4);
  }

  // The error of images without what dims the light.
  ImageError ErrorWithoutDimming(const std::vector<float>& dimmed)
  {
    this->scene.mapper->ShadowsOff();
    this->scene.mapper->SetAmbientOcclusion(0.0);
    const std::vector<float> drawn = this->scene.DrawByProcessor();
    return CompareImages(dimmed.data(), drawn.data(), drawn.size() / 4);
  }
};

}

TEST(LightOfLabels, KeepsTheErrorToleranceWithShadows)
{
  LitTorso torso(8);
  torso.scene.mapper->ShadowsOn();
  const UnlitLook look = torso.LookOfLabels(InterpolatedLook(torso.scene));
  EXPECT_LT(torso.ErrorOf(look).percentile999, 255.0 * UsualTolerance);
  EXPECT_GT(torso.ErrorWithoutDimming(torso.scene.DrawByProcessor()).percentile999, 20.0)
    << "shadows are seen";
}

// The reference of other labels takes minutes.
TEST(LightOfLabels, ThatLookLikeTheVolumeIsThatOfTheVolume)
{
  LitTorso torso(12);
  vtkVolumeProperty* const property = torso.scene.volume->GetProperty();
  property->SetLabelColor(1, torso.scene.colors);
  property->SetLabelScalarOpacity(1, torso.scene.opacities);
  property->SetLabelGradientOpacity(2, nullptr);
  const vtkSmartPointer<vtkImageData> mask = torso.scene.mapper->GetMaskInput();
  for (const bool areBoxes : { false, true })
  {
    areBoxes ? torso.UseBoxes() : property->SetInterpolationTypeToLinear();
    for (const double occlusion : { 0.0, 0.5 })
    {
      torso.scene.mapper->SetShadows(occlusion == 0.0);
      torso.scene.mapper->SetAmbientOcclusion(occlusion);
      torso.scene.mapper->SetMaskInput(mask);
      const std::vector<float> ofLabels = torso.scene.DrawByProcessor();
      torso.RemoveLabels();
      const std::vector<float> ofVolume = torso.scene.DrawByProcessor();
      EXPECT_LT(CompareImages(ofLabels.data(), ofVolume.data(), ofVolume.size() / 4).percentile999,
        2.0 * 255.0 * UsualTolerance)
        << areBoxes << ", " << occlusion;
    }
  }
}

// Shaders cannot judge shadows on surfaces of labels: without a graphics card OpenGL ends them.
TEST(LightOfLabels, InWeakShadowsIsThatWithoutShadows)
{
  LitTorso torso(32);
  for (const bool areSurfaces : { false, true })
  {
    torso.scene.mapper->SetLabelSurfaces(areSurfaces);
    torso.scene.mapper->ShadowsOff();
    const std::vector<float> unshadowed = torso.scene.DrawByProcessor();
    torso.scene.mapper->ShadowsOn();
    torso.scene.mapper->SetShadowStrength(1e-4);
    const std::vector<float> shadowed = torso.scene.DrawByProcessor();
    EXPECT_LT(CompareImages(shadowed.data(), unshadowed.data(), shadowed.size() / 4).percentile999,
      2.0 * 255.0 * UsualTolerance)
      << areSurfaces;
  }
}

TEST(LightOfBoxes, KeepsTheErrorToleranceWithShadows)
{
  for (const double mostOpacity : { 0.02, 0.2, 0.9999 })
  {
    LitTorso torso(12);
    torso.RemoveLabels();
    torso.UseBoxes();
    torso.scene.mapper->ShadowsOn();
    torso.scene.opacities->RemoveAllPoints();
    torso.scene.opacities->AddPoint(-200.0, 0.0);
    torso.scene.opacities->AddPoint(300.0, mostOpacity);
    EXPECT_LT(torso.ErrorOf(LookOfBoxes(torso.scene)).percentile999, 255.0 * UsualTolerance)
      << mostOpacity;
    EXPECT_GT(torso.scene.mapper->GetToleranceSearches(), 0) << "light is sampled";
  }
}

TEST(LightOfBoxes, KeepsTheErrorToleranceWhereMatterScattersIt)
{
  LitTorso torso(8);
  torso.RemoveLabels();
  torso.UseBoxes();
  torso.scene.mapper->ShadowsOn();
  torso.scene.mapper->SetVolumetricScatteringBlending(0.5);
  torso.scene.mapper->SetScatteringAnisotropy(0.3);
  EXPECT_LT(torso.ErrorOf(LookOfBoxes(torso.scene)).percentile999, 255.0 * UsualTolerance);
}

// So few pixels cannot tell 99.9 % of them; under occlusion a single one may exceed the tolerance
// by a quarter in so coarse a torso (Documentation/Reports/Light.md).
TEST(LightOfBoxes, KeepsTheErrorToleranceWithOcclusion)
{
  LitTorso torso(5);
  torso.RemoveLabels();
  torso.UseBoxes();
  torso.scene.mapper->SetAmbientOcclusion(0.5);
  EXPECT_LT(torso.ErrorOf(LookOfBoxes(torso.scene)).largest, 1.25 * 255.0 * UsualTolerance);
  EXPECT_GT(torso.ErrorWithoutDimming(torso.scene.DrawByProcessor()).largest, 20.0)
    << "occlusion is seen";
}

TEST(LightOfBoxes, KeepsTheErrorToleranceWithLabels)
{
  LitTorso torso(6);
  torso.UseBoxes();
  torso.scene.mapper->ShadowsOn();
  const UnlitLook look = torso.LookOfLabels(LookOfBoxes(torso.scene));
  EXPECT_LT(torso.ErrorOf(look).percentile999, 255.0 * UsualTolerance);
}

namespace
{

constexpr double CosineToLight = 0.6;

// The red of a slab of eight voxels, which reflect diffuse light only.
double RedOfSlab(double opacity, double red, int interpolation)
{
  SlabScene slab(opacity, red);
  slab.LightDiffusely();
  slab.volume->GetProperty()->SetInterpolationType(interpolation);
  AddLight(slab.renderer, { 80.0, 0.0, 60.0 }, glm::dvec3(0.0));
  slab.mapper->SetErrorTolerance(1.0 / 255.0);
  const std::vector<float> drawn = slab.DrawByProcessor();
  return drawn[4 * (drawn.size() / 8)];
}

}

// Half of the light is absorbed in the first of eight voxels, or all of it: what is seen of a voxel
// is not in its middle. Opaque matter looks like matter that is nearly opaque.
TEST(LightOfBoxes, OfASlabHasItsClosedFormAndSoHasThatOfInterpolatedVoxels)
{
  constexpr double Red = 0.8;
  constexpr double SlabMm = 8.0;
  for (const double opacity : { 0.1, 0.5, 0.99999, 1.0 })
  {
    const double extinction = -std::log1p(-opacity);
    constexpr double Ways = 1.0 + 1.0 / CosineToLight; // to the eye and to the light
    const double expected =
      Red * CosineToLight / Ways * (1.0 - std::exp(-extinction * Ways * SlabMm));
    for (const int interpolation : { VTK_NEAREST_INTERPOLATION, VTK_LINEAR_INTERPOLATION })
    {
      EXPECT_NEAR(RedOfSlab(opacity, Red, interpolation), expected, 1.25 / 255.0)
        << opacity << ", " << interpolation;
    }
  }
}

// Few pieces of a dull box ask for light.
TEST(LightOfBoxes, ThatAreOpaqueAndDullIsNoMoreThanThatOfAFace)
{
  constexpr double Red = 0.002;
  const double drawn = RedOfSlab(1.0, Red, VTK_NEAREST_INTERPOLATION);
  EXPECT_GT(drawn, 0.0); // false for NaN
  EXPECT_LT(drawn, Red * CosineToLight + 1e-6);
}

// Only packets divide samples that end all light.
TEST(LightOfBoxes, TellWhereShadersDrawDenseMatterTooDark)
{
  const auto messagesOf = [](double opacity, int interpolation, bool byPackets)
  {
    SlabScene slab(opacity, 0.8);
    slab.LightDiffusely();
    AddLight(slab.renderer, { 80.0, 0.0, 60.0 }, glm::dvec3(0.0));
    slab.volume->GetProperty()->SetInterpolationType(interpolation);
    slab.mapper->SetErrorTolerance(UsualTolerance);
    const ExpectedVtkErrors messages;
    byPackets ? slab.DrawByProcessor() : slab.Draw();
    return messages.Text();
  };
  const auto tell = [](const std::string& messages)
  { return messages.find("too dark in its own shadow") != std::string::npos; };
  constexpr double Opaque = 1.0 - 1e-15;
  EXPECT_TRUE(tell(messagesOf(Opaque, VTK_LINEAR_INTERPOLATION, false)));
  EXPECT_FALSE(tell(messagesOf(0.9, VTK_LINEAR_INTERPOLATION, false)));
  EXPECT_TRUE(tell(messagesOf(0.9, VTK_NEAREST_INTERPOLATION, false)));
  EXPECT_FALSE(tell(messagesOf(0.5, VTK_NEAREST_INTERPOLATION, false)));
  EXPECT_EQ(messagesOf(Opaque, VTK_LINEAR_INTERPOLATION, true), "");
}
