// The directions that a soft light comes from.

#include "Core/Geometry/LightCone.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

// The mean of x^a y^b over the unit disc, for even numbers.
double MeanOverDisc(int a, int b)
{
  const auto product = [](int n)
  {
    double all = 1.0;
    for (; n > 1; n -= 2)
    {
      all *= n;
    }
    return all;
  };
  return product(a - 1) * product(b - 1) / product(a + b) * 2.0 / (a + b + 2);
}

}

TEST(LightCone, MeansOverTheDiscAreExactUpToTheSeventhDegree)
{
  for (int degree = 0; degree <= 7; ++degree)
  {
    for (int a = 0; a <= degree; ++a)
    {
      const int b = degree - a;
      double mean = 0.0;
      for (const DiscPoint& point : DiscQuadrature())
      {
        mean += point.weight * std::pow(point.x, a) * std::pow(point.y, b);
      }
      const bool isOdd = a % 2 + b % 2 > 0;
      EXPECT_NEAR(mean, isOdd ? 0.0 : MeanOverDisc(a, b), 1e-14) << a << ", " << b;
    }
  }
}

TEST(LightCone, DirectionsAreUnitVectorsInsideWhoseMeanIsThatOfTheCap)
{
  constexpr double HalfAngle = 0.5;
  for (const glm::dvec3& axis : { glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(0.0, 1.0, 0.0),
         glm::dvec3(0.6, 0.0, -0.8), glm::normalize(glm::dvec3(1.0, 2.0, 3.0)) })
  {
    glm::dvec3 mean(0.0);
    for (const auto& [direction, weight] : DirectionsInCone(axis, HalfAngle))
    {
      EXPECT_NEAR(glm::length(direction), 1.0, 1e-14);
      EXPECT_GT(glm::dot(direction, axis), std::cos(HalfAngle));
      mean += weight * direction;
    }
    EXPECT_LT(glm::length(mean - 0.5 * (1.0 + std::cos(HalfAngle)) * axis), 1e-14);
  }
}
