#ifndef Varimarch_Core_Reference_GrayIntegral_h
#define Varimarch_Core_Reference_GrayIntegral_h

#include "Core/Geometry/SlabQuadrature.h"
#include "Core/Look/TransferBands.h"
#include "Core/Reference/RayIntegral.h"

namespace varimarch
{

/// Base of average and additive intensity: the integral of opacity(v) * gray(v) along a ray, where
/// gray(v) rises from 0 to 1 over the scene's gray range. See Documentation/Mathematics.md.
class GrayIntegral : public RayIntegral
{
protected:
  GrayIntegral(ReferenceScene scene, double tolerance);

  struct Sum
  {
    double integral = 0.0; ///< [mm]
    double lengthMm = 0.0; ///< length of the parts that count [mm]
    double error = 0.0;    ///< estimated error of the integral
  };

  /// @param counted  range of the values that count
  /// @param errorPerMm  largest accepted error of the integral, per length
  Sum SumAlong(const MeasuredRay& ray, ValueRange counted, double errorPerMm) const;

  /// The sum times a factor, at most 1, as white on black; transparent if nothing counts.
  static ReferenceColor White(const Sum& sum, double perMm);

  ReferenceScene scene;
  double tolerance;

private:
  struct Part;
  void AddPart(Sum& sum, const Part& part, double from, double to, int bisections) const;

  TransferBands bands; ///< bands of the opacity, also divided at the ends of the averaged range
  SlabQuadrature quadrature;
};

/// The mean of opacity * gray over the parts of the ray whose values are in the averaged range.
class AverageIntegral : public GrayIntegral
{
public:
  AverageIntegral(ReferenceScene scene, double tolerance);
  ReferenceColor Along(const MeasuredRay& ray) const override;
};

/// The integral of opacity * gray, with lengths in unit distances.
class AdditiveIntegral : public GrayIntegral
{
public:
  AdditiveIntegral(ReferenceScene scene, double tolerance);
  ReferenceColor Along(const MeasuredRay& ray) const override;
};

}

#endif
