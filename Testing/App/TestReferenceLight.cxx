// Scattered and soft light of the reference, compared with the closed forms of
// Documentation/Mathematics.md.

#include "Core/Reference/PathTracer.h"
#include "Scene/Reference/ReferenceRequest.h"

#include <vtkImageData.h>

#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec4.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

constexpr double ClosedFormError = 1e-8;
constexpr double ThicknessMm = 8.0;
constexpr double MatterRed = 0.9;
constexpr double MatterDiffuse = 0.7;

// A slab with faces at z = 0 and z = ThicknessMm, so wide that no light comes through its sides.
// Values change linearly from one face to the other.
vtkSmartPointer<vtkImageData> WideSlab(float bottomValue, float topValue)
{
  constexpr int Side = 3;
  constexpr int Layers = 5;
  constexpr double WidthMm = 2000.0;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Side, Side, Layers);
  image->SetSpacing(0.5 * WidthMm, 0.5 * WidthMm, ThicknessMm / (Layers - 1));
  image->SetOrigin(-0.5 * WidthMm, -0.5 * WidthMm, 0.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* voxel = static_cast<float*>(image->GetScalarPointer());
  for (int z = 0; z < Layers; ++z)
  {
    const float upwards = float(z) / (Layers - 1);
    voxel = std::fill_n(voxel, Side * Side, bottomValue + upwards * (topValue - bottomValue));
  }
  return image;
}

// A unit vector at an angle from the upper face's normal with this cosine.
std::array<double, 3> Upward(double cosine)
{
  return { std::sqrt(1.0 - cosine * cosine), 0.0, cosine };
}

/// A slab of matter that scatters all light of one lamp, unless told otherwise.
struct ScatteringSlab
{
  double opacity; ///< over a millimetre, where the value is 1
  float bottomValue = 1.0f;
  float topValue = 1.0f;
  double anisotropy = 0.0;
  double softnessDegrees = 0.0;
  double reach = 1.0;   ///< see Scattering
  double shadows = 0.0; ///< their strength
  bool scatters = true;
  double drawnReachMm = 0.0;

  double Extinction() const { return -std::log1p(-this->opacity); }

  /// The factor of a colour without what dims the light.
  double ColorOf(double scatteredCosine) const
  {
    return MatterRed * MatterDiffuse * HenyeyGreenstein(scatteredCosine, this->anisotropy);
  }

  /// The slab as the reference draws it.
  /// @param light, eye  cosines of the directions to them with the upper face's normal
  double DrawnRed(double light, double eye)
  {
    const auto image = WideSlab(this->bottomValue, this->topValue);
    const ReferenceRequest request = ReferenceRequestFor(this->SceneIn(light), image, 1e-10);
    this->drawnReachMm = request.lighting->reachMm;
    const auto [x, y, z] = Upward(eye);
    const glm::dvec3 toEye(x, y, z);
    constexpr double DistanceMm = 50.0;
    const glm::dvec3 eyeWorld = glm::dvec3(0.3, 0.2, ThicknessMm) + DistanceMm * toEye;
    const glm::dmat4 gridFromWorld = glm::inverse(request.geometry.worldFromGrid);
    const Ray ray{ glm::dvec3(gridFromWorld * glm::dvec4(eyeWorld, 1.0)),
      -(glm::dmat3(gridFromWorld) * toEye) };
    return IntegratorOf(request).Color(ray, 1.0).rgba.r;
  }

private:
  Scene SceneIn(double light) const
  {
    Scene scene;
    scene.look.colors = { { 0.0, { MatterRed, 0.5, 0.2 } } };
    scene.look.opacities = { { 0.0, 0.0 }, { 1.0, this->opacity } };
    scene.look.shading = { true, 0.0, MatterDiffuse, 0.0, 1.0 };
    SceneLight lamp;
    lamp.kind = LightKind::Directional;
    lamp.direction = Upward(light);
    lamp.softnessDegrees = this->softnessDegrees;
    scene.lights = { lamp };
    scene.shadows = this->shadows;
    scene.scattering = { this->scatters ? 1.0 : 0.0, this->anisotropy, this->reach };
    return scene;
  }
};

// The cosine of the angle by which light is turned, where lamp and eye are in a plane of the normal
// and on the same side of it.
double TurnedCosine(double light, double eye)
{
  return -(light * eye + std::sqrt((1.0 - light * light) * (1.0 - eye * eye)));
}

}

TEST(ReferenceLight, ScatteredBackByASlabHasItsClosedForm)
{
  for (const double anisotropy : { 0.0, 0.6, -0.4 })
  {
    for (const auto& [light, eye] :
      { std::pair(1.0, 1.0), std::pair(0.6, 1.0), std::pair(0.3, 0.8) })
    {
      ScatteringSlab slab{ 0.2 };
      slab.anisotropy = anisotropy;
      const double both = slab.Extinction() * (1.0 / light + 1.0 / eye);
      const double expected = slab.ColorOf(TurnedCosine(light, eye)) * light / (light + eye) *
        (1.0 - std::exp(-both * ThicknessMm));
      EXPECT_NEAR(slab.DrawnRed(light, eye), expected, ClosedFormError)
        << anisotropy << ", " << light << ", " << eye;
    }
  }
}

TEST(ReferenceLight, ScatteredThroughASlabHasItsClosedForm)
{
  for (const double anisotropy : { 0.0, 0.7 })
  {
    for (const auto& [behind, eye] : { std::pair(0.5, 0.9), std::pair(0.9, 0.5) })
    {
      ScatteringSlab slab{ 0.3 };
      slab.anisotropy = anisotropy;
      const double depth = slab.Extinction() * ThicknessMm;
      const double expected = slab.ColorOf(TurnedCosine(-behind, eye)) * behind / (behind - eye) *
        (std::exp(-depth / behind) - std::exp(-depth / eye));
      EXPECT_NEAR(slab.DrawnRed(-behind, eye), expected, ClosedFormError)
        << anisotropy << ", " << behind << ", " << eye;
    }
  }
}

// The light at a depth then depends on the optical depth alone, however matter is distributed.
TEST(ReferenceLight, AlongAndAgainstTheViewDependsOnOpticalDepthAlone)
{
  ScatteringSlab ramp{ 0.4 };
  ramp.bottomValue = 0.0f;
  ramp.anisotropy = 0.3;
  const double depth =
    ThicknessMm / ramp.opacity * ((1.0 - ramp.opacity) * std::log1p(-ramp.opacity) + ramp.opacity);
  EXPECT_NEAR(ramp.DrawnRed(1.0, 1.0), ramp.ColorOf(-1.0) * 0.5 * (1.0 - std::exp(-2.0 * depth)),
    ClosedFormError);
  EXPECT_NEAR(
    ramp.DrawnRed(-1.0, 1.0), ramp.ColorOf(1.0) * depth * std::exp(-depth), ClosedFormError);
}

TEST(ReferenceLight, IsDimmedWithinItsReachOnly)
{
  constexpr double Light = 0.6;
  ScatteringSlab slab{ 0.2 };
  slab.reach = 0.004; // part of the slab's long diagonal
  const double drawn = slab.DrawnRed(Light, 1.0);
  const double extinction = slab.Extinction();
  const double edgeMm = slab.drawnReachMm * Light; // depth above which light comes from outside
  ASSERT_LT(edgeMm, 0.5 * ThicknessMm);
  const double above =
    Light / (Light + 1.0) * (1.0 - std::exp(-extinction * edgeMm * (1.0 + 1.0 / Light)));
  const double below = std::exp(-extinction * slab.drawnReachMm) *
    (std::exp(-extinction * edgeMm) - std::exp(-extinction * ThicknessMm));
  EXPECT_NEAR(drawn, slab.ColorOf(TurnedCosine(Light, 1.0)) * (above + below), ClosedFormError);
}

TEST(ReferenceLight, OnSurfacesLacksTheStrengthOfItsShadows)
{
  for (const double strength : { 0.3, 1.0 })
  {
    ScatteringSlab surface{ 0.4 };
    surface.topValue = 0.0f; // values fall towards lamp and eye
    surface.scatters = false;
    surface.shadows = strength;
    const double depth = ThicknessMm / surface.opacity *
      ((1.0 - surface.opacity) * std::log1p(-surface.opacity) + surface.opacity);
    const double part =
      (1.0 - strength) * (1.0 - std::exp(-depth)) + strength * 0.5 * (1.0 - std::exp(-2.0 * depth));
    EXPECT_NEAR(surface.DrawnRed(1.0, 1.0), MatterRed * MatterDiffuse * part, ClosedFormError)
      << strength;
  }
}

// The rule of 12 directions errs by the fourth power of the cone's height.
TEST(ReferenceLight, OfASoftLampAtTheEyeIsTheMeanOverItsCone)
{
  ScatteringSlab halfSpace{ 0.999 };
  halfSpace.softnessDegrees = 20.0;
  const double cosine = std::cos(glm::radians(halfSpace.softnessDegrees));
  const double mean = 1.0 - std::log(2.0 / (1.0 + cosine)) / (1.0 - cosine);
  EXPECT_NEAR(halfSpace.DrawnRed(1.0, 1.0), halfSpace.ColorOf(-1.0) * mean, ClosedFormError);
  EXPECT_GT(std::abs(mean - 0.5), 1e-3) << "the cone is seen";
}
