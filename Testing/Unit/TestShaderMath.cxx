// Formulas of the shaders, compiled as C++ and compared with double precision.

#include <glm/glm.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace glsl
{
using namespace glm;
#include "Shaders/Math/Absorption.glsl"
#include "Shaders/Math/CellCubic.glsl"
#include "Shaders/Math/CubicSpline.glsl"
#include "Shaders/Math/IntersectBox.glsl"
#include "Shaders/Math/LatticeWalk.glsl"
#include "Shaders/Math/StepGrowth.glsl"
#include "Shaders/Math/WithOpacityFactor.glsl"
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
  const glm::vec2 inside =
    glsl::IntersectBox({ -5.0f, 10.0f, 15.0f }, { 1.0f, 0.0f, 0.0f }, lower, upper);
  EXPECT_FLOAT_EQ(inside.x, 5.0f);
  EXPECT_FLOAT_EQ(inside.y, 15.0f);
}

TEST(IntersectBox, IsEmptyForARayBesideTheBox)
{
  const glm::vec2 inside =
    glsl::IntersectBox({ -5.0f, 21.0f, 15.0f }, { 1.0f, 0.0f, 0.0f }, lower, upper);
  EXPECT_FALSE(inside.x < inside.y);
}

TEST(IntersectBox, IsNeverNotANumberForRaysInTheFaces)
{
  for (float sign : { -1.0f, 1.0f })
  {
    for (float y : { 0.0f, 20.0f })
    {
      const glm::vec2 inside =
        glsl::IntersectBox({ 5.0f, y, 15.0f }, { sign, 0.0f, -0.0f }, lower, upper);
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
    const glsl::LatticePlace behind = glsl::BehindBlock(ray, place, 0.0f);
    EXPECT_GE(behind.t, place.t);
    const glm::vec3 ahead = (behind.cell - place.cell) * (2.0f * ray.ahead - 1.0f);
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
