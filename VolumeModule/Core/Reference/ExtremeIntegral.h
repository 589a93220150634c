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

/// Maximum and minimum intensity: the extreme value along the ray, seen through the transfer
/// function over one unit distance. Exact but for round-off.
class ExtremeIntegral : public RayIntegral
{
public:
  ExtremeIntegral(ReferenceScene scene, Extreme extreme);
  ReferenceColor Along(const MeasuredRay& ray) const override;

private:
  ReferenceScene scene;
  double sign; ///< the extreme is the largest of sign * value
};

}

#endif
