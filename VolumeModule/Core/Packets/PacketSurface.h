#ifndef Varimarch_Core_Packets_PacketSurface_h
#define Varimarch_Core_Packets_PacketSurface_h

// Surfaces, which reflect light.

#include "Core/Packets/ShaderMath.h"

namespace varimarch
{

namespace
{

/// The gradient at a point and what follows from it; all are linear between two points.
struct Surface
{
  Lanes3 gradient;    ///< per voxel
  Lanes3 normalWorld; ///< any length
  Lanes towardsEye;   ///< normal times the direction of the ray
};

inline Surface Mix(const Surface& a, const Surface& b, Lanes part)
{
  return { Mix(a.gradient, b.gradient, part), Mix(a.normalWorld, b.normalWorld, part),
    Mix(a.towardsEye, b.towardsEye, part) };
}

inline Surface Select(LaneMask mask, const Surface& yes, const Surface& no)
{
  return { Select(mask, yes.gradient, no.gradient), Select(mask, yes.normalWorld, no.normalWorld),
    Select(mask, yes.towardsEye, no.towardsEye) };
}

}

}

#endif
