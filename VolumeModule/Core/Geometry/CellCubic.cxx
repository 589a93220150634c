#include "Core/Geometry/CellCubic.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace varimarch
{

namespace
{

/// Linear interpolation that is exact at both ends and for a == b, and never leaves [a, b].
double Mixed(double a, double b, double weight)
{
  return weight < 0.5 ? a + (b - a) * weight : b - (b - a) * (1.0 - weight);
}

double Trilinear(const CellCorners& corners, double x, double y, double z)
{
  const double near = Mixed(Mixed(corners[0], corners[1], x), Mixed(corners[2], corners[3], x), y);
  const double far = Mixed(Mixed(corners[4], corners[5], x), Mixed(corners[6], corners[7], x), y);
  return Mixed(near, far, z);
}

}

// The Bernstein coefficients are values of the blossom. A trilinear function is affine in each
// coordinate, so its blossom along a line is the mean over all assignments of parameters to
// coordinates (Ramshaw, "Blossoms are polar forms", CAGD 1989).
CellCubic::CellCubic(const CellCorners& corners, glm::dvec3 enter, glm::dvec3 leave)
{
  const auto value = [&](double x, double y, double z) { return Trilinear(corners, x, y, z); };
  this->bernstein = { value(enter.x, enter.y, enter.z),
    (value(leave.x, enter.y, enter.z) + value(enter.x, leave.y, enter.z) +
      value(enter.x, enter.y, leave.z)) /
      3.0,
    (value(enter.x, leave.y, leave.z) + value(leave.x, enter.y, leave.z) +
      value(leave.x, leave.y, enter.z)) /
      3.0,
    value(leave.x, leave.y, leave.z) };
}

CellCubic CellCubic::StartingAt(double value) const
{
  return CellCubic({ value, this->bernstein[1], this->bernstein[2], this->bernstein[3] });
}

// De Casteljau's algorithm.
double CellCubic::Value(double u) const
{
  const auto& b = this->bernstein;
  const double middle = Mixed(b[1], b[2], u);
  const double left = Mixed(Mixed(b[0], b[1], u), middle, u);
  const double right = Mixed(middle, Mixed(b[2], b[3], u), u);
  return Mixed(left, right, u);
}

double CellCubic::LowerBound() const
{
  return *std::min_element(this->bernstein.begin(), this->bernstein.end());
}

double CellCubic::UpperBound() const
{
  return *std::max_element(this->bernstein.begin(), this->bernstein.end());
}

CellCubic::Cuts CellCubic::MonotoneCuts() const
{
  // A third of the slope is constant + 2 half u + square u^2.
  const double constant = this->bernstein[1] - this->bernstein[0];
  const double half = this->bernstein[2] - this->bernstein[1] - constant;
  const double square = this->bernstein[3] - this->bernstein[2] - constant - 2.0 * half;

  // Avoids cancellation: one root comes from a sum of two numbers of equal sign, the other from the
  // product of the roots. A root that does not exist is NaN or infinite and therefore not in (0,
  // 1).
  const double sum = -(half + std::copysign(std::sqrt(half * half - square * constant), half));
  std::array<double, 2> roots = { sum / square, constant / sum };
  if (roots[0] > roots[1])
  {
    std::swap(roots[0], roots[1]);
  }
  Cuts cuts{ { 0.0 }, 1 };
  for (const double root : roots)
  {
    if (root > cuts.u[cuts.count - 1] && root < 1.0)
    {
      cuts.u[cuts.count++] = root;
    }
  }
  cuts.u[cuts.count++] = 1.0;
  return cuts;
}

double CellCubic::Slope(double u) const
{
  const auto& b = this->bernstein;
  const double left = Mixed(b[1] - b[0], b[2] - b[1], u);
  const double right = Mixed(b[2] - b[1], b[3] - b[2], u);
  return 3.0 * Mixed(left, right, u);
}

// Newton's method inside a bracket, with bisection if a step would leave the bracket.
double CellCubic::Crossing(double value, double from, double to) const
{
  const bool ascending = this->Value(from) < this->Value(to);
  double u = 0.5 * (from + to);
  constexpr int mostSteps = 100;
  for (int step = 0; step < mostSteps; ++step)
  {
    const double excess = this->Value(u) - value;
    if (excess == 0.0)
    {
      return u;
    }
    ((excess < 0.0) == ascending ? from : to) = u;
    double next = u - excess / this->Slope(u);
    if (!(next > from && next < to))
    {
      next = 0.5 * (from + to);
    }
    if (std::abs(next - u) <= std::numeric_limits<double>::epsilon())
    {
      return next;
    }
    u = next;
  }
  return u;
}

}
