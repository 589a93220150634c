// The pure formulas of the shaders, compiled as C++ and held against double precision.

#include <glm/glm.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace glsl
{
using namespace glm;
#include "Shaders/Math/Absorption.glsl"
#include "Shaders/Math/IntersectBox.glsl"
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

namespace
{
const glm::vec3 lower(0.0f);
const glm::vec3 upper(10.0f, 20.0f, 30.0f);
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
