#ifndef Varimarch_Core_Geometry_SlabQuadrature_h
#define Varimarch_Core_Geometry_SlabQuadrature_h

#include "Core/Look/TransferBands.h"

#include <array>

namespace varimarch
{

/// The volume rendering integral over a piece of a ray, by the 15 point rule of Kronrod.
///
/// Optical depth and colour are a coupled pair: the colour emitted at s is dimmed by the optical
/// depth from the beginning of the piece to s. That depth is the integral of the polynomial through
/// the extinctions at all 15 points, so the pair costs no more samples than one integral. The
/// difference to the 7 point rule of Gauss, whose points are among the 15, is the error estimate:
/// of the coarser rule, so for smooth functions far too large.
class SlabQuadrature
{
public:
  static constexpr int PointCount = 15;

  struct Slab
  {
    double opticalDepth;
    glm::dvec3 rgb; ///< emitted at the front, associated
    double error;   ///< estimate, of rgb and transmittance together
  };

  struct Estimate
  {
    double value;
    double error; ///< estimate
  };

  SlabQuadrature();

  /// Where to sample: positions in (0, 1), ascending.
  const std::array<double, PointCount>& Points() const { return this->points; }

  Slab Integral(const std::array<OpticalProperties, PointCount>& samples, double lengthMm) const;

  /// The plain integral of a function over a length.
  Estimate Integral(const std::array<double, PointCount>& samples, double length) const;

private:
  std::array<double, PointCount> points;
  std::array<double, PointCount> weights;
  std::array<double, PointCount> coarseWeights; ///< 0 at the points that Gauss does not use
  /// Row i integrates the polynomial through values at the points from 0 to point i.
  std::array<std::array<double, PointCount>, PointCount> prefixWeights;
};

}

#endif
