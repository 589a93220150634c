#ifndef Varimarch_Core_Reference_IsosurfaceIntegral_h
#define Varimarch_Core_Reference_IsosurfaceIntegral_h

#include "Core/Reference/RayIntegral.h"

namespace varimarch
{

/// Surfaces of equal value, front to back: each has the colour, shaded where the scene says how,
/// and the opacity that the transfer function gives its value. A surface is where the ray goes from
/// below its value to at least it, or back; what lies at the volume's own faces is none. Exact but
/// for round-off.
class IsosurfaceIntegral : public RayIntegral
{
public:
  /// Values that are not finite are no surfaces.
  explicit IsosurfaceIntegral(ReferenceScene scene);
  ReferenceColor Along(const MeasuredRay& ray) const override;

private:
  ReferenceScene scene; ///< its isovalues sorted, each once
};

}

#endif
