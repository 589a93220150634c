#ifndef Varimarch_Core_Reference_GrayIntegral_h
#define Varimarch_Core_Reference_GrayIntegral_h

#include "Core/Geometry/SlabQuadrature.h"
#include "Core/Look/TransferBands.h"
#include "Core/Reference/RayIntegral.h"

namespace varimarch
{

/// What average and additive intensity share: the integral of opacity(v) * gray(v) along a ray,
/// where gray(v) goes from 0 to 1 over the scene's gray range. See Documentation/Mathematics.md.
class GrayIntegral : public RayIntegral
{
protected:
  GrayIntegral(ReferenceScene scene, double tolerance);

  struct Sum
  {
    double integral = 0.0; ///< [mm]
    double lengthMm = 0.0; ///< of the parts that count
    double error = 0.0;    ///< estimate, of the integral
  };

  /// @param errorPerMm  largest error accepted of the integral over a length
  Sum SumAlong(const MeasuredRay& ray, ValueRange counted, double errorPerMm) const;

  /// A sum times a factor, at most 1, in white on black; clear where nothing counts.
  static ReferenceColor White(const Sum& sum, double perMm);

  ReferenceScene scene;
  double tolerance;

private:
  struct Part;
  void AddPart(Sum& sum, const Part& part, double from, double to, int bisections) const;

  TransferBands bands; ///< of the opacity, cut at the ends of the averaged range too
  SlabQuadrature quadrature;
};

/// The mean of opacity * gray over the parts of the ray whose values are in the averaged range.
class AverageIntegral : public GrayIntegral
{
public:
  AverageIntegral(ReferenceScene scene, double tolerance);
  ReferenceColor Along(const MeasuredRay& ray) const override;
};

/// The integral of opacity * gray over lengths in unit distances.
class AdditiveIntegral : public GrayIntegral
{
public:
  AdditiveIntegral(ReferenceScene scene, double tolerance);
  ReferenceColor Along(const MeasuredRay& ray) const override;
};

}

#endif
