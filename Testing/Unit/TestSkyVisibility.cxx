// The light from all around that reaches places in a slab, compared with closed forms.

#include "Core/Reference/LightTransmittance.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

using namespace varimarch;

namespace
{

constexpr double Rounding = 1e-8;

// The mean of x^a y^b z^c over the sphere.
double MeanOfMonomial(int a, int b, int c)
{
  const auto doubleFactorial = [](int n)
  {
    double product = 1.0;
    for (; n > 1; n -= 2)
    {
      product *= n;
    }
    return product;
  };
  return a % 2 + b % 2 + c % 2 > 0 ? 0.0
                                   : doubleFactorial(a - 1) * doubleFactorial(b - 1) *
      doubleFactorial(c - 1) / doubleFactorial(a + b + c + 1);
}

// The largest error of the quadrature for monomials of a degree.
double ErrorOfDegree(int degree)
{
  double largest = 0.0;
  for (int a = 0; a <= degree; ++a)
  {
    for (int b = 0; a + b <= degree; ++b)
    {
      const int c = degree - a - b;
      double sum = 0.0;
      for (const auto& [d, weight] : SphereQuadrature())
      {
        sum += weight * std::pow(d.x, a) * std::pow(d.y, b) * std::pow(d.z, c);
      }
      largest = std::max(largest, std::abs(sum - MeanOfMonomial(a, b, c)));
    }
  }
  return largest;
}

// A homogeneous slab between z = 0 and z = thickness, so wide that its sides are beyond all
// reaches.
class SkyOfSlab
{
public:
  SkyOfSlab(double extinction, double thicknessMm)
    : extinction(extinction)
    , thicknessMm(thicknessMm)
    , transmittance(SceneOf(extinction, thicknessMm), glm::dmat3(1.0), 1e-12)
  {
  }

  double Drawn(double depthMm, double reachMm) const
  {
    return SkyVisibility(this->transmittance, reachMm).At({ 0.0, 0.0, depthMm });
  }

  // The light that arrives from a direction with this cosine to the outward normal at z = 0.
  double Towards(double depthMm, double cosine, double reachMm) const
  {
    const double sine = std::sqrt(1.0 - cosine * cosine);
    return this->transmittance.Towards({ 0.0, 0.0, depthMm }, { sine, 0.0, -cosine }, reachMm);
  }

  double ExpectedTowards(double depthMm, double cosine, double reachMm) const
  {
    const double faceMm = cosine > 0.0 ? depthMm / cosine : (depthMm - this->thicknessMm) / cosine;
    return std::exp(-this->extinction * std::min(faceMm, reachMm));
  }

private:
  static ReferenceScene SceneOf(double extinction, double thicknessMm)
  {
    CellCorners corners;
    corners.fill(1.0);
    constexpr double HalfWidth = 300.0;
    return { [corners](glm::ivec3) { return corners; },
      { { -HalfWidth, -HalfWidth, 0.0 }, { HalfWidth, HalfWidth, thicknessMm } },
      TransferFunction(
        { { 0.0, { 1.0, 1.0, 1.0 } } }, { { 0.0, -std::expm1(-extinction) } }, 1.0) };
  }

  double extinction;
  double thicknessMm;
  LightTransmittance transmittance;
};

// The points in [0, 1] and the weights of Gauss and Legendre.
std::vector<std::pair<double, double>> GaussLegendre(int count)
{
  std::vector<std::pair<double, double>> points;
  for (int i = 0; i < count; ++i)
  {
    double x = std::cos(std::acos(-1.0) * (i + 0.75) / (count + 0.5));
    double slope = 0.0;
    for (int step = 0; step < 20; ++step)
    {
      double before = 1.0;
      double value = x;
      for (int degree = 2; degree <= count; ++degree)
      {
        const double next = ((2 * degree - 1) * x * value - (degree - 1) * before) / degree;
        before = std::exchange(value, next);
      }
      slope = count * (x * value - before) / (x * x - 1.0);
      x -= value / slope;
    }
    points.emplace_back(0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope));
  }
  return points;
}

// The exponential integral of second order.
double E2(double x)
{
  return std::exp(-x) + x * std::expint(-x);
}

}

TEST(SphereQuadrature, IsExactForPolynomialsUpToDegreeNine)
{
  for (int degree = 0; degree <= 9; ++degree)
  {
    EXPECT_LT(ErrorOfDegree(degree), 1e-15) << degree;
  }
  EXPECT_GT(ErrorOfDegree(10), 1e-3);
}

TEST(SphereQuadrature, HasNoDirectionInAPlaneOfTheAxes)
{
  for (const auto& [direction, weight] : SphereQuadrature())
  {
    EXPECT_NEAR(glm::length(direction), 1.0, 1e-15);
    EXPECT_GT(weight, 0.0);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_GT(std::abs(direction[axis]), 0.02);
    }
  }
}

TEST(SkyVisibility, OfAHomogeneousSlabHasItsClosedForm)
{
  for (const double reachMm : { 3.0, 40.0 })
  {
    for (const double depthMm : { 0.0, 0.5, 4.0, 10.0 })
    {
      const SkyOfSlab slab(0.3, 10.0);
      double expected = 0.0;
      for (const auto& [direction, weight] : SphereQuadrature())
      {
        expected += weight * slab.ExpectedTowards(depthMm, -direction.z, reachMm);
      }
      EXPECT_NEAR(slab.Drawn(depthMm, reachMm), expected, Rounding) << depthMm << ", " << reachMm;
    }
  }
}

// Half of all directions lead out of a half space, and see E2 of its optical depth.
TEST(SkyVisibility, OfAHalfSpaceIsHalfOfE2)
{
  constexpr double Extinction = 0.5;
  constexpr double ReachMm = 100.0; // e^-50 is left
  const SkyOfSlab halfSpace(Extinction, 250.0);
  for (const double depthMm : { 1.0, 2.0, 6.0 })
  {
    double mean = 0.0;
    for (const auto& [cosine, weight] : GaussLegendre(64))
    {
      mean += 0.5 * weight *
        (halfSpace.Towards(depthMm, cosine, ReachMm) +
          halfSpace.Towards(depthMm, -cosine, ReachMm));
    }
    EXPECT_NEAR(mean, 0.5 * E2(Extinction * depthMm), Rounding) << depthMm;
    EXPECT_NEAR(halfSpace.Drawn(depthMm, ReachMm), mean, 0.003) << "the rule of 32 directions";
  }
}

TEST(SkyVisibility, IsSeenTwoVoxelsOutsideASurface)
{
  const glm::dvec3 place(3.0, 4.0, 5.0);
  EXPECT_LT(glm::distance(OutsideOf(place, { 0.0, 0.0, -7.0 }, true), { 3.0, 4.0, 3.0 }), Rounding);
  EXPECT_LT(glm::distance(OutsideOf(place, { 0.3, 0.4, 0.0 }, false), { 1.8, 2.4, 5.0 }), Rounding);
  EXPECT_EQ(OutsideOf(place, glm::dvec3(0.0), true), place) << "no surface";
}

// Matter all around in which light is reflected for ever is as bright as the light.
TEST(SkyVisibility, DimsLessWhereMatterGivesLightBack)
{
  EXPECT_EQ(KeptLight(1.0, 0.7), 1.0);
  EXPECT_EQ(KeptLight(0.0, 0.7), 0.0);
  EXPECT_EQ(KeptLight(0.3, 1.0), 0.3);
  double series = 0.0;
  for (int reflection = 0; reflection < 1000; ++reflection)
  {
    series += 0.3 * std::pow(0.7 * (1.0 - 0.4), reflection);
  }
  EXPECT_NEAR(KeptLight(0.3, 0.4), series, Rounding);
}
