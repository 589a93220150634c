// Curves through points.

#include "Scene/CurvePath.h"
#include "Scene/WorldVector.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

using namespace varimarch;

namespace
{

constexpr double ArcRadiusMm = 40.0;

// Points on a quarter of a circle in the axial plane at z = 5.
std::vector<std::array<double, 3>> QuarterCircle(int count)
{
  std::vector<std::array<double, 3>> points;
  for (int i = 0; i < count; ++i)
  {
    const double angle = glm::half_pi<double>() * i / (count - 1);
    points.push_back({ ArcRadiusMm * std::cos(angle), ArcRadiusMm * std::sin(angle), 5.0 });
  }
  return points;
}

TEST(Curve, HasTheLengthOfTheArcThroughItsPoints)
{
  const CurvePath path(QuarterCircle(9));
  EXPECT_NEAR(path.LengthMm(), glm::half_pi<double>() * ArcRadiusMm, 0.02);
  for (const glm::dvec3& point : path.Points())
  {
    EXPECT_NEAR(std::hypot(point.x, point.y), ArcRadiusMm, 0.12) << "the ends are less curved";
  }
  const CurvePath straight({ { 0, 0, 0 }, { 0, 0, 0 }, { 3, 0, 4 }, { 6, 0, 8 } });
  EXPECT_NEAR(straight.LengthMm(), 10.0, 1e-9) << "a point that is repeated is left out";
  EXPECT_EQ(CurvePath({ { 1, 2, 3 } }).LengthMm(), 0.0);
}

TEST(Curve, PassesThroughItsPointsAtTheirDistances)
{
  const auto points = QuarterCircle(9);
  const CurvePath path(points);
  for (int i = 0; i < 9; ++i)
  {
    const double distanceMm = path.NearestMm(VectorOf(points[i]));
    EXPECT_NEAR(distanceMm, path.LengthMm() * i / 8, 0.02);
    EXPECT_NEAR(glm::distance(path.At(distanceMm, 0.0).pointMm, VectorOf(points[i])), 0.0, 1e-6);
  }
}

TEST(Curve, KeepsTheDirectionAcrossItInAPlane)
{
  const CurvePath path(QuarterCircle(9));
  for (double distanceMm = 0.0; distanceMm < path.LengthMm(); distanceMm += 5.0)
  {
    const CurvePath::Place upright = path.At(distanceMm, 0.0);
    EXPECT_NEAR(upright.across.z, 1.0, 1e-9) << "towards the head";
    EXPECT_NEAR(glm::dot(upright.along, upright.across), 0.0, 1e-9);
    const CurvePath::Place turned = path.At(distanceMm, 90.0);
    const glm::dvec3 outwards = glm::normalize(glm::dvec3(turned.pointMm.x, turned.pointMm.y, 0));
    EXPECT_NEAR(std::abs(glm::dot(turned.across, outwards)), 1.0, 5e-3);
  }
}

TEST(Curve, ReturnsTheWayItCame)
{
  const CurvePath path({ { 0, 0, 0 }, { 10, 0, 0 }, { 0, 0, 0 } });
  const CurvePath::Place place = path.At(0.75 * path.LengthMm(), 0.0);
  EXPECT_TRUE(std::isfinite(place.pointMm.x) && std::isfinite(place.across.x));
}

}
