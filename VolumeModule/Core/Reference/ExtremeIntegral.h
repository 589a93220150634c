#ifndef Varimarch_Core_Reference_ExtremeIntegral_h
#define Varimarch_Core_Reference_ExtremeIntegral_h

#include "Core/Reference/RayIntegral.h"

namespace varimarch
{

enum class Extreme
{
  Largest,
  Smallest,
};

/// Maximum and minimum intensity: the extreme value along the ray, through the transfer function,
/// over one unit distance. Exact up to rounding.
class ExtremeIntegral : public RayIntegral
{
public:
  ExtremeIntegral(ReferenceScene scene, Extreme extreme);
  ReferenceColor Along(const MeasuredRay& ray) const override;

private:
  ReferenceScene scene;
  double sign; ///< 1 or -1: the extreme is the largest sign * value
};

}

#endif
