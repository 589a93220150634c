#ifndef Varimarch_Core_Reference_IsosurfaceIntegral_h
#define Varimarch_Core_Reference_IsosurfaceIntegral_h

#include "Core/Reference/RayIntegral.h"

namespace varimarch
{

/// Surfaces of equal value, front to back. Each has the colour (shaded if the scene is) and the
/// opacity that the transfer function assigns to its value. A ray passes a surface where it goes
/// from below the isovalue to at least the isovalue, or back. The faces of the volume are not
/// surfaces. Exact up to rounding.
class IsosurfaceIntegral : public RayIntegral
{
public:
  /// Ignores isovalues that are not finite.
  explicit IsosurfaceIntegral(ReferenceScene scene);
  ReferenceColor Along(const MeasuredRay& ray) const override;

private:
  ReferenceScene scene; ///< with sorted, unique isovalues
};

}

#endif
