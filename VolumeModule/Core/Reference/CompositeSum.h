#ifndef Varimarch_Core_Reference_CompositeSum_h
#define Varimarch_Core_Reference_CompositeSum_h

#include "Core/Geometry/SlabQuadrature.h"
#include "Core/Reference/RayIntegral.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{

/// Emission and absorption along one ray, accumulated front to back.
class CompositeSum
{
public:
  /// @param tolerance  largest accepted error of a channel
  CompositeSum(const SlabQuadrature& quadrature, double tolerance, double rayLengthMm)
    : quadrature(quadrature)
    , tolerance(tolerance)
    , rayLengthMm(rayLengthMm)
  {
  }

  /// True if nothing behind can be seen.
  bool Finished() const { return this->transmittance < 0.1 * this->tolerance; }

  ReferenceColor Color() const;

  void AddHomogeneous(const OpticalProperties& properties, double lengthMm);

  /// Adds a part in which the optical properties are smooth, or nearly so.
  /// @param propertiesAt  returns the OpticalProperties at a parameter in (from, to)
  template <class PropertiesAt>
  void AddVarying(const PropertiesAt& propertiesAt, double from, double to, double mmPerParameter);

private:
  template <class PropertiesAt>
  void AddBisected(const PropertiesAt& propertiesAt, double from, double to, double mmPerParameter,
    int bisections);

  const SlabQuadrature& quadrature;
  double tolerance;
  double rayLengthMm;
  glm::dvec3 rgb = glm::dvec3(0.0);
  double transmittance = 1.0;
  double error = 0.0;
};

template <class PropertiesAt>
void CompositeSum::AddVarying(
  const PropertiesAt& propertiesAt, double from, double to, double mmPerParameter)
{
  constexpr int mostBisections = 50;
  this->AddBisected(propertiesAt, from, to, mmPerParameter, mostBisections);
}

template <class PropertiesAt>
void CompositeSum::AddBisected(
  const PropertiesAt& propertiesAt, double from, double to, double mmPerParameter, int bisections)
{
  if (this->Finished())
  {
    return;
  }
  // A piece may use the fraction of the tolerance that it has of the ray's length. A lower limit
  // lets the bisection end where it cuts through the end of a curve, at which extinction may have a
  // pole.
  const double lengthMm = (to - from) * mmPerParameter;
  const double share = std::max(lengthMm / this->rayLengthMm, 0.01);
  std::array<OpticalProperties, SlabQuadrature::PointCount> samples;
  for (int i = 0; i < SlabQuadrature::PointCount; ++i)
  {
    samples[i] = propertiesAt(from + (to - from) * this->quadrature.Points()[i]);
  }
  // In deeper pieces the colour may come from a layer so thin that all points miss it.
  constexpr double deepest = 2.0;
  const SlabQuadrature::Slab slab = this->quadrature.Integral(samples, lengthMm);
  if (slab.opticalDepth <= deepest && !(this->transmittance * slab.error > share * this->tolerance))
  {
    this->rgb += this->transmittance * slab.rgb;
    this->error += this->transmittance * slab.error;
    this->transmittance *= std::exp(-slab.opticalDepth);
    return;
  }
  const double middle = 0.5 * (from + to);
  if (bisections == 0)
  {
    // The piece is as thin as rounding errors; matter so dense is treated as a surface.
    this->error += this->transmittance * std::min(1.0, slab.opticalDepth);
    this->AddHomogeneous(propertiesAt(middle), lengthMm);
    return;
  }
  this->AddBisected(propertiesAt, from, middle, mmPerParameter, bisections - 1);
  this->AddBisected(propertiesAt, middle, to, mmPerParameter, bisections - 1);
}

}

#endif
