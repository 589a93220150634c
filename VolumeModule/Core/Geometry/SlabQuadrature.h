#ifndef Varimarch_Core_Geometry_SlabQuadrature_h
#define Varimarch_Core_Geometry_SlabQuadrature_h

#include "Core/Look/TransferBands.h"

#include <array>

namespace varimarch
{

/// Quadrature of the volume rendering integral over a piece of a ray, by Kronrod's 15 point rule.
///
/// Optical depth and colour are coupled: the colour emitted at s is attenuated by the optical depth
/// from the beginning of the piece to s. This depth is the integral of the polynomial through the
/// extinctions at all 15 points, so both integrals need the samples of one. The error estimate is
/// the difference to Gauss's 7 point rule, whose points are among the 15. It is the error of the
/// coarser rule, and therefore far too large for smooth functions.
class SlabQuadrature
{
public:
  static constexpr int PointCount = 15;

  struct Slab
  {
    double opticalDepth;
    glm::dvec3 rgb; ///< emission that reaches the front, premultiplied
    double error;   ///< estimated error of rgb and transmittance together
  };

  struct Estimate
  {
    double value;
    double error; ///< estimated error
  };

  SlabQuadrature();

  /// Positions to sample, in (0, 1), ascending.
  const std::array<double, PointCount>& Points() const { return this->points; }

  Slab Integral(const std::array<OpticalProperties, PointCount>& samples, double lengthMm) const;

  /// Integral of one function over a length.
  Estimate Integral(const std::array<double, PointCount>& samples, double length) const;

private:
  std::array<double, PointCount> points;
  std::array<double, PointCount> weights;
  std::array<double, PointCount> coarseWeights; ///< 0 at points that the Gauss rule does not use
  /// Row i integrates the polynomial through the values at the points, from 0 to point i.
  std::array<std::array<double, PointCount>, PointCount> prefixWeights;
};

}

#endif
