// Light that a slab scatters once or often, compared with closed forms.

#include "Core/Geometry/LightCone.h"
#include "Core/Reference/PathTracer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

using namespace varimarch;

namespace
{

constexpr int Paths = 20000;
// Estimates differ from the truth by more than 4 standard errors once in 16000 times; seeds are
// fixed.
constexpr double StandardErrors = 4.0;

/// A homogeneous slab from z = 0 down to a depth, so wide that nothing leaves by its sides. Every
/// second brick has a majorant that is too large, which must not matter.
ScatteringScene Slab(double extinction, double depthMm, double albedo)
{
  ScatteringScene scene;
  scene.boxGrid = { glm::dvec3(-1e9, -1e9, -depthMm), glm::dvec3(1e9, 1e9, 0.0) };
  scene.worldFromGrid = glm::dmat4(1.0);
  scene.majorants = { 1e6, glm::ivec3(2, 1, 1), { extinction, 3.0 * extinction } };
  scene.matter = [=](glm::dvec3) { return OpticalProperties{ glm::dvec3(albedo), extinction }; };
  return scene;
}

// A unit vector at an angle from the outward normal with this cosine.
glm::dvec3 Outward(double cosine)
{
  return { std::sqrt(1.0 - cosine * cosine), 0.0, cosine };
}

// The slab as an eye sees it from a direction with this cosine to its normal.
ReferenceColor Seen(const ScatteringScene& scene, double cosine = 1.0, int paths = Paths)
{
  const glm::dvec3 toEye = Outward(cosine);
  const Ray ray{ glm::dvec3(0.5) + 10.0 * toEye, -toEye };
  return PathTracer(scene).Color(ray, { 0.0, 1e12 }, paths, 1);
}

// The function H of isotropic scattering in half spaces, from its integral equation (Chandrasekhar,
// "Radiative transfer", 1950), by iteration with midpoints.
double ChandrasekharH(double albedo, double cosine)
{
  constexpr int Points = 400;
  const auto at = [](int i) { return (i + 0.5) / Points; };
  std::vector<double> h(Points, 1.0);
  const auto next = [&](double mu)
  {
    double sum = 0.0;
    for (int i = 0; i < Points; ++i)
    {
      sum += at(i) * h[i] / (mu + at(i)) / Points;
    }
    return 1.0 / (std::sqrt(1.0 - albedo) + 0.5 * albedo * sum);
  };
  for (int iteration = 0; iteration < 60; ++iteration)
  {
    std::vector<double> better;
    for (int i = 0; i < Points; ++i)
    {
      better.push_back(next(at(i)));
    }
    h = better;
  }
  return next(cosine);
}

}

TEST(PathTracer, HenyeyGreensteinHasTheMeanOneAndItsMeanCosine)
{
  for (const double g : { -0.7, 0.0, 0.3, 0.9 })
  {
    double mean = 0.0;
    double meanCosine = 0.0;
    constexpr int Points = 100000;
    for (int i = 0; i < Points; ++i)
    {
      const double cosine = 2.0 * (i + 0.5) / Points - 1.0;
      mean += HenyeyGreenstein(cosine, g) / Points;
      meanCosine += cosine * HenyeyGreenstein(cosine, g) / Points;
    }
    EXPECT_NEAR(mean, 1.0, 1e-6);
    EXPECT_NEAR(meanCosine, g, 1e-6);
  }
}

TEST(PathTracer, OfMatterThatScattersNothingIsBlackAndAbsorbs)
{
  ScatteringScene scene = Slab(0.5, 2.0, 0.0);
  scene.lights = { { true, Outward(1.0), glm::dvec3(1.0) } };
  scene.environment = glm::dvec3(1.0);
  const ReferenceColor color = Seen(scene);
  EXPECT_EQ(glm::dvec3(color.rgba), glm::dvec3(0.0));
  EXPECT_NEAR(color.rgba.a, 1.0 - std::exp(-1.0), StandardErrors * color.error);
}

TEST(PathTracer, ScatteringOnceInASlabHasItsClosedForm)
{
  const double extinction = 0.4;
  const double depthMm = 5.0;
  for (const double g : { 0.0, 0.6, -0.4 })
  {
    ScatteringScene scene = Slab(extinction, depthMm, 0.8);
    const double cosine = 0.6;
    scene.anisotropy = g;
    scene.mostScatterings = 1;
    scene.lights = { { true, Outward(cosine), glm::dvec3(2.0, 1.0, 0.5) } };
    const ReferenceColor color = Seen(scene);
    // Light that comes down to the eye above has been turned by the angle whose cosine is -cosine.
    const double both = extinction + extinction / cosine;
    const double expected =
      0.8 * HenyeyGreenstein(-cosine, g) * extinction / both * (1.0 - std::exp(-both * depthMm));
    EXPECT_NEAR(color.rgba.r, 2.0 * expected, StandardErrors * color.error);
    EXPECT_NEAR(color.rgba.b, 0.5 * expected, StandardErrors * color.error);
    EXPECT_LT(color.error, 0.01 * expected + 0.005);
  }
}

TEST(PathTracer, ASoftLightIsTheMeanOverItsCone)
{
  const double extinction = 0.4;
  const double depthMm = 5.0;
  const double softness = 0.4;
  ScatteringScene scene = Slab(extinction, depthMm, 1.0);
  scene.mostScatterings = 1;
  scene.lights = { { true, Outward(0.6), glm::dvec3(1.0), softness } };
  double expected = 0.0;
  for (const auto& [direction, weight] : DirectionsInCone(Outward(0.6), softness))
  {
    const double both = extinction + extinction / direction.z;
    expected += weight * extinction / both * (1.0 - std::exp(-both * depthMm));
  }
  const ReferenceColor color = Seen(scene);
  EXPECT_NEAR(color.rgba.r, expected, StandardErrors * color.error);
}

TEST(PathTracer, ANearLightShinesOnlyFromItsPlaceOn)
{
  ScatteringScene scene = Slab(0.4, 5.0, 1.0);
  scene.mostScatterings = 1;
  scene.lights = { { false, glm::dvec3(0.5, 0.5, 1e7), glm::dvec3(1.0) } };
  const ReferenceColor far = Seen(scene);
  EXPECT_NEAR(far.rgba.r, 0.5 * (1.0 - std::exp(-4.0)), StandardErrors * far.error);
  // Behind the slab it shines through what the eye does not look through.
  scene.lights[0].place.z = -1e7;
  const ReferenceColor behind = Seen(scene);
  EXPECT_NEAR(behind.rgba.r, 2.0 * std::exp(-2.0), StandardErrors * behind.error);
}

TEST(PathTracer, MatterThatLosesNothingIsAsBrightAsItsSurroundings)
{
  for (const double g : { 0.0, 0.8, -0.5 })
  {
    ScatteringScene scene = Slab(1.0, 3.0, 1.0);
    scene.anisotropy = g;
    scene.environment = glm::dvec3(1.0);
    const ReferenceColor color = Seen(scene, 0.7, 2000);
    EXPECT_EQ(color.rgba.r, color.rgba.a); // each path ends outside, with a part of 1
  }
}

TEST(PathTracer, NoMatterIsBrighterThanItsSurroundings)
{
  ScatteringScene scene = Slab(1.0, 3.0, 0.9);
  scene.environment = glm::dvec3(1.0);
  const ReferenceColor color = Seen(scene);
  EXPECT_LT(color.rgba.r, color.rgba.a - 0.05);
  EXPECT_GT(color.rgba.r, 0.5 * color.rgba.a);
}

TEST(PathTracer, AHalfSpaceReflectsAsChandrasekharSays)
{
  for (const double albedo : { 0.5, 0.9 })
  {
    for (const auto& [light, eye] : { std::pair(0.5, 0.8), std::pair(0.8, 0.5) })
    {
      ScatteringScene scene = Slab(1.0, 60.0, albedo);
      scene.lights = { { true, Outward(light), glm::dvec3(1.0) } };
      const ReferenceColor color = Seen(scene, eye, 2 * Paths);
      const double expected = albedo * light / (light + eye) * ChandrasekharH(albedo, light) *
        ChandrasekharH(albedo, eye);
      EXPECT_NEAR(color.rgba.r, expected, StandardErrors * color.error);
      EXPECT_LT(color.error, 0.02 * expected);
    }
  }
}

TEST(PathTracer, TellsTheDeviationOfItsMeans)
{
  ScatteringScene scene = Slab(0.4, 5.0, 0.9);
  scene.lights = { { true, Outward(0.5), glm::dvec3(1.0) } };
  const PathTracer tracer(scene);
  const Ray ray{ glm::dvec3(0.5, 0.5, 1.0), glm::dvec3(0.0, 0.0, -1.0) };
  constexpr int Seeds = 300;
  double sum = 0.0;
  double squares = 0.0;
  double variance = 0.0;
  for (int seed = 0; seed < Seeds; ++seed)
  {
    const ReferenceColor color = tracer.Color(ray, { 0.0, 100.0 }, 100, seed);
    sum += color.rgba.r / Seeds;
    squares += color.rgba.r * color.rgba.r / Seeds;
    variance += color.error * color.error / Seeds;
  }
  EXPECT_NEAR(std::sqrt((squares - sum * sum) / variance), 1.0, 0.2);
}

TEST(PathTracer, RepeatsItselfBySeed)
{
  ScatteringScene scene = Slab(0.4, 5.0, 0.9);
  scene.environment = glm::dvec3(1.0);
  EXPECT_EQ(Seen(scene, 1.0, 50).rgba, Seen(scene, 1.0, 50).rgba);
}

TEST(PathTracer, RefusesAnAnisotropyWithoutADensity)
{
  ScatteringScene scene = Slab(0.4, 5.0, 0.9);
  scene.anisotropy = 1.0;
  EXPECT_THROW(PathTracer{ scene }, std::invalid_argument);
}
