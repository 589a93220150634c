// Formulas of the shaders, compiled as C++ and compared with double precision.

#include "Core/Fields/LightLattice.h"
#include "Core/Reference/LightTransmittance.h"

#include <glm/glm.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

using namespace varimarch;

namespace glsl
{
using namespace glm;
// clang-format off
#include "Shaders/Math/Absorption.glsl"
#include "Shaders/Math/BlinnPhong.glsl"
#include "Shaders/Math/CellCubic.glsl"
#include "Shaders/Math/CubicCrossing.glsl"
#include "Shaders/Math/CubicSpline.glsl"
#include "Shaders/Math/Gradients.glsl"
#include "Shaders/Math/IntersectBox.glsl"
#include "Shaders/Math/LatticeWalk.glsl"
#include "Shaders/Math/OpenSky.glsl"
#include "Shaders/Math/Planes.glsl"
#include "Shaders/Math/PreIntegration.glsl"
#include "Shaders/Math/StepGrowth.glsl"
#include "Shaders/Math/Tables.glsl"
#include "Shaders/Math/UnevenPlace.glsl"
#include "Shaders/Math/Extinction.glsl"
#include "Shaders/Math/LabelMixture.glsl"
// clang-format on
}

TEST(Absorption, KeepsItsDigitsFromTinyToHugeDepths)
{
  for (double depth = 1e-30; depth < 100.0; depth *= 1.37)
  {
    const double expected = -std::expm1(-double(float(depth)));
    EXPECT_NEAR(glsl::Absorption(float(depth)) / expected, 1.0, 1e-6) << depth;
  }
  EXPECT_EQ(glsl::Absorption(0.0f), 0.0f);
  EXPECT_EQ(glsl::Absorption(100.0f), 1.0f);
}

TEST(WithOpacityFactor, MultipliesTheOpacityOfAUnitDistance)
{
  for (const double unit : { 0.1, 1.0, 30.0 })
  {
    for (double depth = 1e-12; depth < 40.0; depth *= 1.7)
    {
      for (const double factor : { 0.0, 1e-6, 0.02, 0.3, 0.9, 1.0 })
      {
        const double extinction = float(depth / unit);
        const double expected =
          -std::log1p(factor * std::expm1(-extinction * float(unit))) / float(unit);
        const double found = glsl::WithOpacityFactor(float(extinction), float(unit), float(factor));
        EXPECT_NEAR(found, expected, 3e-6 * expected) << depth << " " << unit << " " << factor;
      }
    }
  }
  EXPECT_EQ(glsl::WithOpacityFactor(1e30f, 1.0f, 1.0f), 1e30f) << "opaque stays opaque";
}

namespace
{
const glm::vec3 lower(0.0f);
const glm::vec3 upper(10.0f, 20.0f, 30.0f);
}

TEST(CellCubic, IsTheCubicThroughFourValues)
{
  const auto cubic = [](double u) { return 0.3 - 2.0 * u + 5.0 * u * u - 3.5 * u * u * u; };
  const glm::vec4 b =
    glsl::CubicThrough(glm::vec4(cubic(0.0), cubic(1.0 / 3.0), cubic(2.0 / 3.0), cubic(1.0)));
  for (double u = 0.0; u <= 1.0; u += 1.0 / 64.0)
  {
    EXPECT_NEAR(glsl::CubicValue(b, float(u)), cubic(u), 1e-6);
  }
  EXPECT_EQ(glsl::CubicValue(b, 1.0f), float(cubic(1.0)));
}

TEST(CellCubic, IsMonotoneBetweenItsExtremesAndCrossesEachValueOnce)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<float> number(-1.0f, 1.0f);
  for (int i = 0; i < 2000; ++i)
  {
    const glm::vec4 b(number(random), number(random), number(random), number(random));
    const glm::vec2 extremes = glsl::CubicExtremes(b);
    for (const glm::vec2 part :
      { glm::vec2(0.0f, extremes.x), extremes, glm::vec2(extremes.y, 1.0f) })
    {
      ASSERT_LE(part.x, part.y);
      const float first = glsl::CubicValue(b, part.x);
      const float last = glsl::CubicValue(b, part.y);
      for (float along = 0.1f; along < 1.0f; along += 0.2f)
      {
        const float inside = glsl::CubicValue(b, glm::mix(part.x, part.y, along));
        EXPECT_GE(inside, std::min(first, last) - 1e-5f);
        EXPECT_LE(inside, std::max(first, last) + 1e-5f);
        const float value = glm::mix(first, last, along);
        EXPECT_NEAR(glsl::CubicValue(b, glsl::CubicCrossing(b, value, part)), value, 1e-5f);
      }
    }
  }
}

TEST(CubicSpline, ReadsTheFourCoefficientsOfAnAxisTwoByTwo)
{
  // Weights of the four coefficients that the linear samples combine.
  const auto weightsOf = [](const glsl::SplineReadings& at)
  {
    return std::array<double, 4>{ -at.nearWeight.x * at.nearPlace.x,
      at.nearWeight.x * (1.0 + at.nearPlace.x), at.farWeight.x * (2.0 - at.farPlace.x),
      at.farWeight.x * (at.farPlace.x - 1.0) };
  };
  for (double x = 0.0; x <= 1.0; x += 1.0 / 32.0)
  {
    const double y = 1.0 - x;
    const std::array<double, 4> value = { y * y * y / 6.0,
      (4.0 - 6.0 * x * x + 3.0 * x * x * x) / 6.0, (4.0 - 6.0 * y * y + 3.0 * y * y * y) / 6.0,
      x * x * x / 6.0 };
    const std::array<double, 4> slope = { -y * y / 2.0, (3.0 * x * x - 4.0 * x) / 2.0,
      (4.0 * y - 3.0 * y * y) / 2.0, x * x / 2.0 };
    const auto drawnValue = weightsOf(glsl::SplineValue(glm::vec3(float(x))));
    const auto drawnSlope = weightsOf(glsl::SplineSlope(glm::vec3(float(x))));
    for (int i = 0; i < 4; ++i)
    {
      EXPECT_NEAR(drawnValue[i], value[i], 1e-6) << x << " " << i;
      EXPECT_NEAR(drawnSlope[i], slope[i], 1e-6) << x << " " << i;
    }
  }
}

TEST(IntersectBox, GivesWhereARayEntersAndLeaves)
{
  const glm::vec2 inside = glsl::IntersectBox(
    { -5.0f, 10.0f, 15.0f }, glsl::SafeInverse({ 1.0f, 0.0f, 0.0f }), lower, upper);
  EXPECT_FLOAT_EQ(inside.x, 5.0f);
  EXPECT_FLOAT_EQ(inside.y, 15.0f);
}

TEST(IntersectBox, IsEmptyForARayBesideTheBox)
{
  const glm::vec2 inside = glsl::IntersectBox(
    { -5.0f, 21.0f, 15.0f }, glsl::SafeInverse({ 1.0f, 0.0f, 0.0f }), lower, upper);
  EXPECT_FALSE(inside.x < inside.y);
}

TEST(IntersectBox, IsNeverNotANumberForRaysInTheFaces)
{
  for (float sign : { -1.0f, 1.0f })
  {
    for (float y : { 0.0f, 20.0f })
    {
      const glm::vec2 inside = glsl::IntersectBox(
        { 5.0f, y, 15.0f }, glsl::SafeInverse({ sign, 0.0f, -0.0f }), lower, upper);
      EXPECT_FLOAT_EQ(inside.x, -5.0f);
      EXPECT_FLOAT_EQ(inside.y, 5.0f);
    }
  }
}

namespace
{

// Requires that every block is one cell, and that the ray always advances to an adjacent cell
// ahead.
void ExpectAdvance(const glm::vec3& start, const glm::vec3& direction)
{
  const glsl::LatticeRay ray = glsl::RayInLattice(start - 3000.0f * direction, direction);
  glsl::LatticePlace place = glsl::PlaceAt(ray, 2996.0f, glm::vec3(8.0f));
  for (int block = 0; block < 40; ++block)
  {
    const glsl::LatticePlace behind = glsl::BehindCell(ray, place);
    const glsl::LatticePlace behindBlock = glsl::BehindBlock(ray, place, 0.0f);
    EXPECT_EQ(behindBlock.cell, behind.cell);
    EXPECT_EQ(behindBlock.t, behind.t);
    EXPECT_GE(behind.t, place.t);
    const glm::vec3 ahead = (behind.cell - place.cell) * ray.outward;
    EXPECT_GE(ahead.x + ahead.y + ahead.z, 1.0f);
    EXPECT_GE(std::min({ ahead.x, ahead.y, ahead.z }), 0.0f);
    EXPECT_LE(std::max({ ahead.x, ahead.y, ahead.z }), 1.0f);
    place = behind;
  }
}

}

TEST(LatticeWalk, AdvancesWithEveryBlockWhateverTheDirection)
{
  // Directions in a face, along an edge, nearly so, and with steps that are lost to rounding.
  const glm::vec3 corner(4.0f, 4.0f, 4.0f);
  for (const glm::vec3& direction : { glm::vec3(1.0f, 0.0f, 0.0f), { 1.0f, -0.0f, -1e-35f },
         { 1.0f, -1e-20f, 0.0f }, { 0.7f, 0.7f, -1e-6f }, { -1e-3f, -1.0f, 1e-7f } })
  {
    ExpectAdvance(corner, direction);
  }
  std::mt19937 random(5);
  std::uniform_real_distribution<float> number(-1.0f, 1.0f);
  for (int i = 0; i < 1000; ++i)
  {
    ExpectAdvance(corner, glm::vec3(number(random), number(random), number(random)));
  }
}

TEST(LatticeWalk, LeavesABlockAtItsNearestFace)
{
  const glsl::LatticeRay ray = glsl::RayInLattice({ 0.5f, 20.25f, 3.5f }, { 1.0f, -0.5f, 0.0f });
  const glsl::LatticePlace behind =
    glsl::BehindBlock(ray, glsl::PlaceAt(ray, 2.0f, glm::vec3(32.0f)), 1.0f);
  EXPECT_FLOAT_EQ(behind.t, 3.5f); // cells 1 ... 3 and 18 ... 20: left at x = 4
  EXPECT_EQ(behind.cell, glm::vec3(4.0f, 18.0f, 3.0f));
}

TEST(StepGrowth, BeginsBehindHalfOfTheLightAndIsLimited)
{
  EXPECT_FLOAT_EQ(glsl::StepGrowth(1.0f), 1.0f);
  EXPECT_FLOAT_EQ(glsl::StepGrowth(0.5f), 1.0f);
  EXPECT_FLOAT_EQ(glsl::StepGrowth(0.125f), 2.0f);
  EXPECT_FLOAT_EQ(glsl::StepGrowth(0.0f), 4.0f);
}

TEST(Tables, InterpolateUpToTheirLastEntry)
{
  EXPECT_EQ(glsl::TableIndex(0.5f, 100.0f, 1.0f, 255.0f), 51.0f);
  EXPECT_EQ(glsl::TableIndex(-9.0f, 100.0f, 1.0f, 255.0f), 0.0f);
  EXPECT_EQ(glsl::TableIndex(9.0f, 100.0f, 1.0f, 255.0f), 255.0f);
  EXPECT_EQ(glsl::EntryBelow(51.75f, 255.0f), 51.0f);
  EXPECT_EQ(glsl::EntryBelow(255.0f, 255.0f), 254.0f) << "there is an entry above it";
}

TEST(PreIntegration, CountsWhatIsBeyondTheTableByItsLength)
{
  const glm::vec4 inside(1.0f, 2.0f, 3.0f, 4.0f);
  const glm::vec4 below(0.5f);
  const glm::vec4 above(8.0f);
  const auto mean = [&](float start, float end)
  { return glsl::WithEnds(inside, start, end, 10.0f, below, above); };
  EXPECT_EQ(mean(2.0f, 5.0f), inside);
  EXPECT_EQ(mean(-2.0f, -1.0f), below);
  EXPECT_EQ(mean(12.0f, 11.0f), above);
  const glm::vec4 mixed = mean(20.0f, -5.0f); // a fifth below, two fifths inside and above
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(mixed[i], 0.2f * below[i] + 0.4f * inside[i] + 0.4f * above[i], 1e-6f);
  }
}

TEST(Planes, KeepTheSideThatTheyFace)
{
  const glm::vec4 plane(1.0f, 0.0f, 0.0f, -3.0f); // x >= 3
  const auto kept = [&](const glm::vec3& origin, const glm::vec3& direction)
  {
    return glsl::CutByPlane(
      { 0.0f, 10.0f }, glsl::BeyondPlane(plane, origin), glsl::ApproachToPlane(plane, direction));
  };
  EXPECT_EQ(kept({ 1.0f, 0.0f, 0.0f }, { 0.5f, 1.0f, 0.0f }), glm::vec2(4.0f, 10.0f));
  EXPECT_EQ(kept({ 5.0f, 0.0f, 0.0f }, { -0.5f, 1.0f, 0.0f }), glm::vec2(0.0f, 4.0f));
  EXPECT_EQ(kept({ 5.0f, 0.0f, 0.0f }, { 0.0f, 1.0f, 0.0f }), glm::vec2(0.0f, 10.0f));
  const glm::vec2 none = kept({ 1.0f, 0.0f, 0.0f }, { 0.0f, 1.0f, 0.0f });
  EXPECT_GE(none.x, none.y) << "a ray along the plane, on the side that is cut off";
}

TEST(UnevenPlace, IsLinearOnBothSidesOfAPlaceWhereTheSpacingChanges)
{
  const glm::vec4 piece(4.0f, 2.0f, 0.5f, 3.0f);
  EXPECT_EQ(glsl::UnevenPlace(3.0f, piece), 1.5f);
  EXPECT_EQ(glsl::UnevenPlace(4.5f, piece), 3.5f);
  EXPECT_EQ(glsl::SpacingBin(3.9f, 0.0f, 2.0f, 10.0f, 20.0f), 17.0f);
  EXPECT_EQ(glsl::SpacingBin(-1.0f, 0.0f, 2.0f, 10.0f, 20.0f), 10.0f);
  EXPECT_EQ(glsl::SpacingBin(99.0f, 0.0f, 2.0f, 10.0f, 20.0f), 20.0f);
}

TEST(BlinnPhong, IsTheModelInDoublePrecision)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<float> number(-1.0f, 1.0f);
  const auto vector = [&] { return glm::vec3(number(random), number(random), number(random)); };
  for (int i = 0; i < 1000; ++i)
  {
    const glm::vec3 normal = 100.0f * vector();
    const glm::vec3 toLight = glm::normalize(vector());
    const glm::vec3 toEye = glm::normalize(vector());
    const glm::dvec3 unit = glm::normalize(glm::dvec3(normal));
    EXPECT_NEAR(glsl::FacingEye(normal, -glm::dot(normal, toEye)),
      std::abs(glm::dot(unit, glm::dvec3(toEye))), 1e-5);
    const double diffuse = glm::dot(unit, glm::dvec3(toLight));
    EXPECT_NEAR(glsl::Facing(glm::vec3(unit), toLight, 0.0f), std::max(diffuse, 0.0), 1e-5);
    EXPECT_NEAR(glsl::Facing(glm::vec3(unit), toLight, 1.0f), std::abs(diffuse), 1e-5);
    const glm::dvec3 halfway = glm::normalize(glm::dvec3(toLight) + glm::dvec3(toEye));
    EXPECT_NEAR(glsl::Shining(glm::vec3(unit), toLight, toEye, 0.0f),
      std::max(glm::dot(unit, halfway), 1e-6), 1e-4);
  }
  EXPECT_EQ(glsl::FacingEye(glm::vec3(0.0f), 0.0f), 0.0f) << "there is no normal";
  const glm::vec3 lit = glsl::LitFromEye({ 1.0f, 0.5f, 0.0f }, 0.5f, 0.5f,
    { 0.1f, 0.8f, 0.4f, 2.0f }, glm::vec3(1.0f), glm::vec3(1.0f, 0.0f, 0.0f));
  EXPECT_NEAR(lit.x, 0.1f + 0.2f + 0.05f, 1e-6f);
  EXPECT_NEAR(lit.y, 0.5f * 0.3f, 1e-6f);
  EXPECT_EQ(lit.z, 0.0f);
}

TEST(BlinnPhong, ANearLightReachesItsConeOnly)
{
  const glm::vec3 along(0.0f, 0.0f, -1.0f);
  const auto reach = [&](const glm::vec3& toLight, float exponent) {
    return glsl::LightReach({ 1.0f, 0.5f, 0.25f }, 2.0f, toLight, along, 0.8f, exponent);
  };
  EXPECT_NEAR(reach({ 0.0f, 0.0f, 1.0f }, 0.0f), 1.0f / 3.0f, 1e-6f);
  EXPECT_NEAR(reach({ 0.436f, 0.0f, 0.9f }, 2.0f), 0.81f / 3.0f, 1e-6f);
  EXPECT_EQ(reach({ 0.8f, 0.0f, 0.6f }, 0.0f), 0.0f) << "outside the cone";
}

TEST(Gradients, AreMeasuredPerMeanSpacingAndEndWithTheTable)
{
  const glm::vec3 factors(1.0f, 2.0f, 0.5f);
  EXPECT_EQ(glsl::GradientIndex({ 3.0f, 2.0f, 0.0f }, factors, 10.0f, 255.0f), 50.0f);
  EXPECT_EQ(glsl::GradientIndex({ 300.0f, 0.0f, 0.0f }, factors, 10.0f, 255.0f), 255.0f);
  EXPECT_EQ(glsl::DampedPart({ 0.3f, 0.2f, 0.0f }, factors), 0.5f);
  EXPECT_EQ(glsl::DampedPart({ 3.0f, 2.0f, 0.0f }, factors), 1.0f);
}

TEST(LabelMixture, MixesTheOpacitiesOfAUnitDistance)
{
  const double opacity = 0.75 * -std::expm1(-0.2 * 5.0) + 0.25 * -std::expm1(-2.0 * 5.0);
  EXPECT_NEAR(glsl::MixedExtinction(0.2f, 2.0f, 0.25f, 5.0f), -std::log1p(-opacity) / 5.0, 1e-6);
  EXPECT_LT(glsl::MixedExtinction(1e30f, 1e30f, 0.5f, 1.0f), 100.0f);
}

TEST(OpenSky, IsSeenFromWhereTheReferenceSeesIt)
{
  const glm::dvec3 place(3.0, 4.0, 5.0);
  for (const glm::dvec3 gradient : { glm::dvec3(0.3, -0.2, 0.7), glm::dvec3(-90.0, 2.0, 0.0) })
  {
    for (const bool isThinnerUp : { false, true })
    {
      const glm::dvec3 way(glsl::WayOutside(
        glm::vec3(gradient), isThinnerUp ? 0.5f : 1.0f, isThinnerUp ? 1.0f : 0.5f));
      EXPECT_LT(glm::length(place + way - OutsideOf(place, gradient, isThinnerUp)), 1e-5);
      EXPECT_NEAR(glm::length(way), LightLattice::SkyDistanceVoxels, 1e-5);
    }
  }
  EXPECT_EQ(glsl::WayOutside(glm::vec3(0.0f), 1.0f, 0.0f), glm::vec3(0.0f));
  EXPECT_FLOAT_EQ(glsl::ChangePerVoxel(glm::vec3(0.0f, 6.0f, 8.0f)), 5.0f);
}

TEST(OpenSky, LeavesTheLightThatTheReferenceKeeps)
{
  for (const double visible : { 0.0, 0.2, 1.0 })
  {
    for (const double strength : { 0.1, 1.0 })
    {
      EXPECT_NEAR(
        glsl::KeptLight(float(visible), float(strength)), KeptLight(visible, strength), 1e-6);
    }
  }
}
