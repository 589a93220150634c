// Numbers that VTK's setters accept although they have no meaning: NaN, infinite, negative, 0 and
// huge ones. Each is named in one sentence, and no pixel is NaN.

#include "Module/Robustness/OddNumbers.h"

#include <vtkCamera.h>
#include <vtkContourValues.h>
#include <vtkInformation.h>
#include <vtkInformationDoubleKey.h>
#include <vtkMatrix4x4.h>
#include <vtkPlane.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

double LargestOf(const std::vector<float>& pixels)
{
  return *std::max_element(pixels.begin(), pixels.end());
}

// Expects a sentence that names the setting of a change, and what was expected of it.
DrawnByBoth ExpectSentence(OddScenes& scenes, const NamedChange& change)
{
  const DrawnByBoth drawn = scenes.DrawTwice(change);
  ExpectFinite(drawn, change.name);
  EXPECT_NE(drawn.text.find(change.name), std::string::npos) << change.name << ": " << drawn.text;
  const bool says = drawn.text.find("expected") != std::string::npos ||
    drawn.text.find("must be") != std::string::npos;
  EXPECT_TRUE(says) << change.name << ": " << drawn.text;
  return drawn;
}

// Expects such sentences, and images that show something.
void ExpectReplaced(const std::vector<NamedChange>& changes)
{
  OddScenes scenes;
  for (const NamedChange& change : changes)
  {
    const DrawnByBoth drawn = ExpectSentence(scenes, change);
    EXPECT_FALSE(IsEmpty(drawn.images.front())) << change.name;
    EXPECT_FALSE(IsEmpty(drawn.images.back())) << change.name;
  }
}

}

TEST(OddNumbers, OfLightsAreReplacedAndNamed)
{
  OddScenes scenes;
  const NamedChange changes[] = {
    { "SetAttenuationValues", [](LitBall& s) { s.lamp->SetAttenuationValues(0.0, 0.0, 0.0); } },
    { "SetIntensity", [](LitBall& s) { s.lamp->SetIntensity(NotANumber); } },
    { "SetIntensity", [](LitBall& s) { s.head->SetIntensity(Infinite); } },
    { "SetDiffuseColor", [](LitBall& s) { s.lamp->SetDiffuseColor(0.5, NotANumber, 0.5); } },
    { "SetPosition", [](LitBall& s) { s.lamp->SetPosition(NotANumber, 0.0, 0.0); } },
    { "SetPosition", [](LitBall& s) { s.lamp->SetFocalPoint(Infinite, 0.0, 0.0); } },
    { "SetConeAngle", [](LitBall& s) { s.lamp->SetConeAngle(NotANumber); } },
    { "SetConeAngle", [](LitBall& s) { s.lamp->SetConeAngle(-5.0); } },
    { "SetExponent", [](LitBall& s) { s.lamp->SetExponent(NotANumber); } },
    { "LIGHT_SOFTNESS",
      [](LitBall& s)
      {
        vtkNew<vtkInformation> keys;
        keys->Set(vtkVariationFieldVolumeMapper::LIGHT_SOFTNESS(), NotANumber);
        s.lamp->SetInformation(keys);
      } },
  };
  for (const NamedChange& change : changes)
  {
    ExpectSentence(scenes, change);
  }
}

TEST(OddNumbers, OfAPropertyAreReplacedAndNamed)
{
  OddScenes scenes;
  const NamedChange changes[] = {
    { "SetAmbient", [](LitBall& s) { s.volume->GetProperty()->SetAmbient(NotANumber); } },
    { "SetDiffuse", [](LitBall& s) { s.volume->GetProperty()->SetDiffuse(-Infinite); } },
    { "SetSpecular", [](LitBall& s) { s.volume->GetProperty()->SetSpecular(NotANumber); } },
    { "SetSpecularPower", [](LitBall& s) { s.volume->GetProperty()->SetSpecularPower(-5.0); } },
    { "SetSpecularPower",
      [](LitBall& s) { s.volume->GetProperty()->SetSpecularPower(NotANumber); } },
    { "opacity unit distance",
      [](LitBall& s) { s.volume->GetProperty()->SetScalarOpacityUnitDistance(0.0); } },
    { "opacity unit distance",
      [](LitBall& s) { s.volume->GetProperty()->SetScalarOpacityUnitDistance(NotANumber); } },
    { "opacity unit distance",
      [](LitBall& s) { s.volume->GetProperty()->SetScalarOpacityUnitDistance(Infinite); } },
    { "opacity unit distance",
      [](LitBall& s) { s.volume->GetProperty()->SetScalarOpacityUnitDistance(-1.0); } },
    { "isovalue",
      [](LitBall& s)
      {
        s.mapper->SetBlendModeToIsoSurface();
        s.volume->GetProperty()->GetIsoSurfaceValues()->SetValue(0, NotANumber);
      } },
    { "slice",
      [](LitBall& s)
      {
        vtkNew<vtkPlane> plane;
        plane->SetNormal(NotANumber, 0.0, 1.0);
        s.mapper->SetBlendModeToSlice();
        s.volume->GetProperty()->SetSliceFunction(plane);
      } },
  };
  for (const NamedChange& change : changes)
  {
    const DrawnByBoth drawn = ExpectSentence(scenes, change);
    EXPECT_LT(LargestOf(drawn.images.front()), 10.0) << change.name;
  }
}

TEST(OddNumbers, OfSamplesAndTheImageAreReplacedAndNamed)
{
  ExpectReplaced({
    { "SetErrorTolerance", [](LitBall& s) { s.mapper->SetErrorTolerance(NotANumber); } },
    { "SetSampleDistance",
      [](LitBall& s)
      {
        s.mapper->AutoAdjustSampleDistancesOff();
        s.mapper->SetSampleDistance(NotANumber);
      } },
    { "SetSampleDistanceInVoxels",
      [](LitBall& s)
      {
        s.mapper->AutoAdjustSampleDistancesOff();
        s.mapper->SetSampleDistanceInVoxels(NotANumber);
      } },
    { "SetFirstDistance", [](LitBall& s) { s.mapper->SetFirstDistance(NotANumber); } },
    { "SetImageSampleDistance", [](LitBall& s) { s.mapper->SetImageSampleDistance(NAN); } },
    { "SetFinalColorWindow", [](LitBall& s) { s.mapper->SetFinalColorWindow(NAN); } },
    { "SetFinalColorLevel", [](LitBall& s) { s.mapper->SetFinalColorLevel(INFINITY); } },
  });
}

TEST(OddNumbers, OfTheLightOfMatterAreReplacedAndNamed)
{
  ExpectReplaced({
    { "SetShadowStrength",
      [](LitBall& s)
      {
        s.mapper->ShadowsOn();
        s.mapper->SetShadowStrength(NotANumber);
      } },
    { "SetAmbientOcclusion", [](LitBall& s) { s.mapper->SetAmbientOcclusion(NotANumber); } },
    { "SetAmbientOcclusionReach",
      [](LitBall& s)
      {
        s.mapper->SetErrorTolerance(1.0 / 64.0);
        s.mapper->SetAmbientOcclusion(1.0);
        s.mapper->SetAmbientOcclusionReach(NotANumber);
      } },
    { "SetVolumetricScatteringBlending",
      [](LitBall& s) { s.mapper->SetVolumetricScatteringBlending(NotANumber); } },
    { "SetGlobalIlluminationReach",
      [](LitBall& s) { s.mapper->SetGlobalIlluminationReach(NotANumber); } },
    { "SetScatteringAnisotropy",
      [](LitBall& s) { s.mapper->SetScatteringAnisotropy(NotANumber); } },
    { "SetDampingGradient", [](LitBall& s) { s.mapper->SetDampingGradient(NotANumber); } },
  });
}

TEST(OddNumbers, OfGapsAndCutsAreReplacedAndNamed)
{
  ExpectReplaced({
    { "SetNanColor", [](LitBall& s) { s.mapper->SetNanColor(0.5, NotANumber, 0.5); } },
    { "SetNanOpacity", [](LitBall& s) { s.mapper->SetNanOpacity(NotANumber); } },
    { "SetEarlyTerminationTransmittance",
      [](LitBall& s) { s.mapper->SetEarlyTerminationTransmittance(NotANumber); } },
    { "SetCroppingRegionPlanes",
      [](LitBall& s)
      {
        s.mapper->CroppingOn();
        s.mapper->SetCroppingRegionPlanes(-4.0, NotANumber, -4.0, 4.0, -4.0, 4.0);
      } },
    { "vtkPlane",
      [](LitBall& s)
      {
        vtkNew<vtkPlane> plane;
        plane->SetNormal(0.0, NotANumber, 1.0);
        s.mapper->AddClippingPlane(plane);
      } },
  });
}

TEST(OddNumbers, OfPlacesAreNamedAndNothingIsDrawn)
{
  OddScenes scenes;
  const auto withMatrix = [](double number)
  {
    return [number](LitBall& s)
    {
      vtkNew<vtkMatrix4x4> matrix;
      matrix->SetElement(1, 1, number);
      s.volume->SetUserMatrix(matrix);
    };
  };
  const NamedChange changes[] = {
    { "spacing", [](LitBall& s) { s.image->SetSpacing(0.0, 1.0, 1.0); } },
    { "spacing", [](LitBall& s) { s.image->SetSpacing(1.0, NotANumber, 1.0); } },
    { "spacing", [](LitBall& s) { s.image->SetSpacing(1.0, 1.0, Infinite); } },
    { "origin", [](LitBall& s) { s.image->SetOrigin(NotANumber, 0.0, 0.0); } },
    { "user matrix", withMatrix(NotANumber) },
    { "user matrix", withMatrix(0.0) },
    { "position", [](LitBall& s) { s.volume->SetPosition(0.0, NotANumber, 0.0); } },
    { "camera",
      [](LitBall& s) { s.renderer->GetActiveCamera()->SetPosition(NotANumber, 0.0, 0.0); } },
    { "camera", [](LitBall& s) { s.renderer->GetActiveCamera()->SetViewAngle(NotANumber); } },
  };
  for (const NamedChange& change : changes)
  {
    ExpectSentence(scenes, change);
  }
}

TEST(OddNumbers, OfALampFarAwayMakeItALightAtInfinity)
{
  OddScenes scenes;
  const auto place = [](double distanceMm, bool isPositional)
  {
    return [=](LitBall& s)
    {
      s.lamp->SetPosition(-distanceMm, -distanceMm, distanceMm);
      s.lamp->SetPositional(isPositional);
      s.lamp->SetConeAngle(90.0);
    };
  };
  const DrawnByBoth distant = scenes.Draw(place(1.0, false));
  for (const double distanceMm : { 1e14, 1e16, 1e30, 1e200 })
  {
    const DrawnByBoth drawn = scenes.Draw(place(distanceMm, true));
    EXPECT_EQ(drawn.text, "") << distanceMm;
    ExpectFinite(drawn, "far away");
    for (std::size_t i = 0; i < drawn.images.size(); ++i)
    {
      for (std::size_t number = 0; number < drawn.images[i].size(); ++number)
      {
        ASSERT_NEAR(drawn.images[i][number], distant.images[i][number], 1e-5) << distanceMm;
      }
    }
  }
}

TEST(OddNumbers, OfALampThatHasNoConstantAttenuationDoNotMakeItInfinite)
{
  OddScenes scenes;
  const auto inside = [](double constant)
  {
    return [=](LitBall& s)
    {
      s.mapper->ShadowsOn();
      s.lamp->SetPosition(0.0, 0.0, 0.0);
      s.lamp->SetConeAngle(90.0);
      s.lamp->SetAttenuationValues(constant, 0.0, 1.0);
    };
  };
  ExpectFinite(scenes.Draw(inside(0.0)), "no constant attenuation");
}
