#include "Core/Geometry/Box.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace varimarch;

namespace
{
const Box unitBox{ glm::dvec3(0.0), glm::dvec3(1.0) };
}

TEST(Box, RayThroughTheMiddleEntersAndLeavesAtTheFaces)
{
  const Interval inside = Intersection({ { -2.0, 0.5, 0.5 }, { 2.0, 0.0, 0.0 } }, unitBox);
  EXPECT_DOUBLE_EQ(inside.enter, 1.0);
  EXPECT_DOUBLE_EQ(inside.exit, 1.5);
}

TEST(Box, RayFromInsideStartsAtItsOrigin)
{
  const Interval inside = Intersection({ { 0.25, 0.5, 0.5 }, { 1.0, 0.0, 0.0 } }, unitBox);
  EXPECT_EQ(inside.enter, 0.0);
  EXPECT_DOUBLE_EQ(inside.exit, 0.75);
}

TEST(Box, BoxBehindTheOriginIsMissed)
{
  EXPECT_TRUE(Intersection({ { 2.0, 0.5, 0.5 }, { 1.0, 0.0, 0.0 } }, unitBox).IsEmpty());
}

TEST(Box, RayInThePlaneOfAFaceIsInside)
{
  for (const double face : { 0.0, 1.0 })
  {
    const Interval inside = Intersection({ { -1.0, face, face }, { 1.0, 0.0, 0.0 } }, unitBox);
    EXPECT_DOUBLE_EQ(inside.enter, 1.0);
    EXPECT_DOUBLE_EQ(inside.exit, 2.0);
  }
}

TEST(Box, RayBesideTheBoxAndParallelToItMisses)
{
  EXPECT_TRUE(Intersection({ { -1.0, 1.0000001, 0.5 }, { 1.0, 0.0, 0.0 } }, unitBox).IsEmpty());
  EXPECT_TRUE(Intersection({ { -1.0, 0.5, -1e-7 }, { 1.0, -0.0, -0.0 } }, unitBox).IsEmpty());
}

TEST(Box, LimitsCutTheInterval)
{
  const Ray ray{ { -1.0, 0.5, 0.5 }, { 1.0, 0.0, 0.0 } };
  const Interval inside = Intersection(ray, unitBox, { 1.25, 1.5 });
  EXPECT_DOUBLE_EQ(inside.enter, 1.25);
  EXPECT_DOUBLE_EQ(inside.exit, 1.5);
  EXPECT_TRUE(Intersection(ray, unitBox, { 2.5, 3.0 }).IsEmpty());
}

TEST(Box, UnboundedBoxGivesTheWholeRayEvenWithZeroDirectionComponents)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const Box everything{ glm::dvec3(-infinity), glm::dvec3(infinity) };
  const Interval inside = Intersection({ { 1.0, 2.0, 3.0 }, { 1.0, 0.0, -1.0 } }, everything);
  EXPECT_EQ(inside.enter, 0.0);
  EXPECT_EQ(inside.exit, infinity);
}

TEST(Box, RandomPointsOnTheRayAgreeWithTheInterval)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> position(-2.0, 3.0);
  std::uniform_real_distribution<double> component(-1.0, 1.0);
  for (int i = 0; i < 20000; ++i)
  {
    Ray ray{ { position(random), position(random), position(random) },
      { component(random), component(random), component(random) } };
    ray.direction[i % 4 % 3] *= i % 5 == 0 ? 0.0 : 1.0;
    const Interval inside = Intersection(ray, unitBox);
    const double t = std::abs(position(random));
    const glm::dvec3 point = ray.origin + t * ray.direction;
    const bool pointInside = point == glm::clamp(point, unitBox.lower, unitBox.upper);
    EXPECT_EQ(pointInside, t >= inside.enter && t <= inside.exit && !inside.IsEmpty());
  }
}
