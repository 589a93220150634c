#include "Core/Geometry/SlabQuadrature.h"

#include <glm/common.hpp>

#include <cmath>

namespace varimarch
{

namespace
{

constexpr int pointCount = SlabQuadrature::PointCount;
constexpr int half = pointCount / 2;

// Nodes in [0, 1) of the interval [-1, 1] and weights, from Piessens et al., "QUADPACK" (1983),
// routine QK15. The Gauss rule uses every second node, including the middle one.
constexpr double kronrodPoints[half + 1] = { 0.0, 0.207784955007898467600689403773245,
  0.405845151377397166906606412076961, 0.586087235467691130294144691693013,
  0.741531185599394439863864773280788, 0.864864423359769072789712788640926,
  0.949107912342758524526189684047851, 0.991455371120812639206854697526329 };
constexpr double kronrodWeights[half + 1] = { 0.209482141084727828012999174891714,
  0.204432940075298892414161999234649, 0.190350578064785409913256402421014,
  0.169004726639267902826583426598550, 0.140653259715525918745189590510238,
  0.104790010322250183839876322541518, 0.063092092629978553290700663189204,
  0.022935322010529224963732008058970 };
constexpr double gaussWeights[half / 2 + 1] = { 0.417959183673469387755102040816327,
  0.381830050505118944950369775488975, 0.279705391489276667901467771423780,
  0.129484966168869693270611432679082 };

/// The polynomial that is 1 at one of the points and 0 at all others.
double Lagrange(const std::array<double, pointCount>& points, int one, double x)
{
  double product = 1.0;
  for (int i = 0; i < pointCount; ++i)
  {
    product *= i == one ? 1.0 : (x - points[i]) / (points[one] - points[i]);
  }
  return product;
}

}

SlabQuadrature::SlabQuadrature()
{
  for (int i = 0; i < pointCount; ++i)
  {
    const int fromMiddle = std::abs(i - half);
    const double side = i < half ? -1.0 : 1.0;
    this->points[i] = 0.5 + 0.5 * side * kronrodPoints[fromMiddle];
    this->weights[i] = 0.5 * kronrodWeights[fromMiddle];
    this->coarseWeights[i] = fromMiddle % 2 == 0 ? 0.5 * gaussWeights[fromMiddle / 2] : 0.0;
  }
  // The polynomials have degree 14; the rule is exact up to degree 22.
  for (int i = 0; i < pointCount; ++i)
  {
    for (int j = 0; j < pointCount; ++j)
    {
      double integral = 0.0;
      for (int k = 0; k < pointCount; ++k)
      {
        integral += this->weights[k] * Lagrange(this->points, j, this->points[i] * this->points[k]);
      }
      this->prefixWeights[i][j] = this->points[i] * integral;
    }
  }
}

SlabQuadrature::Slab SlabQuadrature::Integral(
  const std::array<OpticalProperties, PointCount>& samples, double lengthMm) const
{
  Slab fine{ 0.0, glm::dvec3(0.0), 0.0 };
  Slab coarse = fine;
  for (int i = 0; i < pointCount; ++i)
  {
    double depth = 0.0;
    for (int j = 0; j < pointCount; ++j)
    {
      depth += this->prefixWeights[i][j] * samples[j].extinction;
    }
    const double extinction = samples[i].extinction * lengthMm;
    const glm::dvec3 emitted = samples[i].rgb * (extinction * std::exp(-depth * lengthMm));
    fine.opticalDepth += this->weights[i] * extinction;
    fine.rgb += this->weights[i] * emitted;
    coarse.opticalDepth += this->coarseWeights[i] * extinction;
    coarse.rgb += this->coarseWeights[i] * emitted;
  }
  const glm::dvec3 difference = glm::abs(fine.rgb - coarse.rgb);
  fine.error = std::max(std::max(difference.r, difference.g), difference.b) +
    std::abs(fine.opticalDepth - coarse.opticalDepth);
  return fine;
}

SlabQuadrature::Estimate SlabQuadrature::Integral(
  const std::array<double, PointCount>& samples, double length) const
{
  double fine = 0.0;
  double coarse = 0.0;
  for (int i = 0; i < pointCount; ++i)
  {
    fine += this->weights[i] * samples[i];
    coarse += this->coarseWeights[i] * samples[i];
  }
  return { length * fine, length * std::abs(fine - coarse) };
}

}
