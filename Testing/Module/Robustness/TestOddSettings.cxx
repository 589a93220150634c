// A sweep of numbers without a meaning through settings of lights, property, mapper and camera: no
// pixel is NaN, and no image is empty without a word.

#include "Module/Robustness/OddNumbers.h"

#include <vtkCamera.h>
#include <vtkPlane.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{

/// A setting of any number.
struct Setting
{
  std::string name;
  std::function<void(LitBall&, double)> set;
};

std::vector<Setting> SettingsOfLights()
{
  return {
    { "intensity", [](LitBall& s, double x) { s.lamp->SetIntensity(x); } },
    { "colour", [](LitBall& s, double x) { s.lamp->SetColor(x, 0.5, 0.5); } },
    { "ambient colour", [](LitBall& s, double x) { s.lamp->SetAmbientColor(x, 0.5, 0.5); } },
    { "specular colour", [](LitBall& s, double x) { s.lamp->SetSpecularColor(x, 0.5, 0.5); } },
    { "place", [](LitBall& s, double x) { s.lamp->SetPosition(x, 3.0, 5.0); } },
    { "focus", [](LitBall& s, double x) { s.lamp->SetFocalPoint(x, 0.0, 0.0); } },
    { "cone", [](LitBall& s, double x) { s.lamp->SetConeAngle(x); } },
    { "exponent", [](LitBall& s, double x) { s.lamp->SetExponent(x); } },
    { "constant attenuation",
      [](LitBall& s, double x) { s.lamp->SetAttenuationValues(x, 0.0, 0.0); } },
    { "linear attenuation",
      [](LitBall& s, double x) { s.lamp->SetAttenuationValues(0.0, x, 0.0); } },
    { "quadratic attenuation",
      [](LitBall& s, double x) { s.lamp->SetAttenuationValues(0.0, 0.0, x); } },
    { "head light", [](LitBall& s, double x) { s.head->SetIntensity(x); } },
  };
}

std::vector<Setting> SettingsOfProperty()
{
  const auto set = [](void (vtkVolumeProperty::*setter)(double))
  { return [setter](LitBall& s, double x) { (s.volume->GetProperty()->*setter)(x); }; };
  return {
    { "ambient", set(&vtkVolumeProperty::SetAmbient) },
    { "diffuse", set(&vtkVolumeProperty::SetDiffuse) },
    { "specular", set(&vtkVolumeProperty::SetSpecular) },
    { "power", set(&vtkVolumeProperty::SetSpecularPower) },
    { "unit distance", set(&vtkVolumeProperty::SetScalarOpacityUnitDistance) },
    { "opacity", [](LitBall& s, double x) { s.opacities->AddPoint(4.0, x); } },
    { "value of an opacity", [](LitBall& s, double x) { s.opacities->AddPoint(x, 0.3); } },
    { "colour", [](LitBall& s, double x) { s.colors->AddRGBPoint(3.0, x, 0.5, 0.5); } },
    { "value of a colour", [](LitBall& s, double x) { s.colors->AddRGBPoint(x, 0.2, 0.5, 0.5); } },
    { "gradient opacity",
      [](LitBall& s, double x)
      {
        vtkNew<vtkPiecewiseFunction> curve;
        curve->AddPoint(0.0, 0.2);
        curve->AddPoint(1.0, x);
        s.volume->GetProperty()->SetGradientOpacity(curve);
      } },
    { "gradient",
      [](LitBall& s, double x)
      {
        vtkNew<vtkPiecewiseFunction> curve;
        curve->AddPoint(0.5, 0.2);
        curve->AddPoint(x, 0.8);
        s.volume->GetProperty()->SetGradientOpacity(curve);
      } },
  };
}

std::vector<Setting> SettingsOfMapper()
{
  const auto set = [](void (vtkVariationFieldVolumeMapper::*setter)(double))
  { return [setter](LitBall& s, double x) { (s.mapper->*setter)(x); }; };
  using Mapper = vtkVariationFieldVolumeMapper;
  return {
    { "tolerance", set(&Mapper::SetErrorTolerance) },
    { "variation tolerance",
      [](LitBall& s, double x)
      {
        s.mapper->SetAccelerationModeToVariationField();
        s.mapper->SetVariationTolerance(x);
      } },
    { "first distance", set(&Mapper::SetFirstDistance) },
    { "shadow strength",
      [](LitBall& s, double x)
      {
        s.mapper->ShadowsOn();
        s.mapper->SetShadowStrength(x);
      } },
    { "scattering", set(&Mapper::SetVolumetricScatteringBlending) },
    { "damping", set(&Mapper::SetDampingGradient) },
    { "window", [](LitBall& s, double x) { s.mapper->SetFinalColorWindow(float(x)); } },
    { "level", [](LitBall& s, double x) { s.mapper->SetFinalColorLevel(float(x)); } },
    { "averaged range",
      [](LitBall& s, double x)
      {
        s.mapper->SetBlendModeToAverageIntensity();
        s.mapper->SetAverageIPScalarRange(x, 6.0);
      } },
  };
}

std::vector<Setting> SettingsOfCuts()
{
  return {
    { "cropping",
      [](LitBall& s, double x)
      {
        s.mapper->CroppingOn();
        s.mapper->SetCroppingRegionFlagsToFence();
        s.mapper->SetCroppingRegionPlanes(x, 2.0, -2.0, 2.0, -2.0, 2.0);
      } },
    { "clipping plane",
      [](LitBall& s, double x)
      {
        vtkNew<vtkPlane> plane;
        plane->SetNormal(0.3, 0.4, 0.5);
        plane->SetOrigin(x, 0.0, 0.0);
        s.mapper->AddClippingPlane(plane);
      } },
  };
}

std::vector<Setting> SettingsOfPlaces()
{
  return {
    { "spacing", [](LitBall& s, double x) { s.image->SetSpacing(x, 1.0, 1.0); } },
    { "origin", [](LitBall& s, double x) { s.image->SetOrigin(x, -4.0, -4.0); } },
    // VTK leaves a volume whose matrix is not finite along x out before it asks a mapper.
    { "scale", [](LitBall& s, double x) { s.volume->SetScale(1.0, x, 1.0); } },
    { "position of the eye",
      [](LitBall& s, double x) { s.renderer->GetActiveCamera()->SetPosition(x, -30.0, 10.0); } },
    { "view angle", [](LitBall& s, double x) { s.renderer->GetActiveCamera()->SetViewAngle(x); } },
    { "clipping range",
      [](LitBall& s, double x) { s.renderer->GetActiveCamera()->SetClippingRange(x, 100.0); } },
    { "parallel scale",
      [](LitBall& s, double x)
      {
        s.renderer->GetActiveCamera()->ParallelProjectionOn();
        s.renderer->GetActiveCamera()->SetParallelScale(x);
      } },
  };
}

// True if a setting of a number may hide all of a ball that is drawn as asked for.
bool MayHide(const std::string& setting)
{
  const char* const hide[] = { "unit distance", "variation tolerance", "opacity",
    "value of an opacity", "gradient opacity", "gradient", "first distance", "window", "level",
    "averaged range", "cropping", "clipping plane", "spacing", "origin", "scale",
    "position of the eye", "view angle", "clipping range", "parallel scale" };
  return std::find(std::begin(hide), std::end(hide), setting) != std::end(hide);
}

void Sweep(const std::vector<Setting>& settings)
{
  OddScenes scenes;
  const double numbers[] = { NotANumber, Infinite, -Infinite, 0.0, -1.0, 1e30, -1e30, 1e-30,
    std::numeric_limits<double>::max() };
  for (const Setting& setting : settings)
  {
    for (const double number : numbers)
    {
      const DrawnByBoth drawn = scenes.Draw([&](LitBall& scene) { setting.set(scene, number); });
      const std::string name = setting.name + " " + std::to_string(number);
      ExpectFinite(drawn, name);
      const bool hides = !std::isnan(number) && MayHide(setting.name);
      for (const std::vector<float>& image : drawn.images)
      {
        EXPECT_TRUE(hides || !drawn.text.empty() || !IsEmpty(image)) << name;
      }
    }
  }
}

}

TEST(OddNumbers, InAnySettingOfLightsMakeNoPixelWithoutANumber)
{
  Sweep(SettingsOfLights());
}

TEST(OddNumbers, InAnySettingOfAPropertyMakeNoPixelWithoutANumber)
{
  Sweep(SettingsOfProperty());
}

TEST(OddNumbers, InAnySettingOfTheMapperMakeNoPixelWithoutANumber)
{
  Sweep(SettingsOfMapper());
}

TEST(OddNumbers, InAnyCutMakeNoPixelWithoutANumber)
{
  Sweep(SettingsOfCuts());
}

TEST(OddNumbers, InAnyPlaceMakeNoPixelWithoutANumber)
{
  Sweep(SettingsOfPlaces());
}
