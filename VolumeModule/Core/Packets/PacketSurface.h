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

/// A surface, and the part of the light from all around that reaches it.
struct OpenSurface : Surface
{
  Lanes open; ///< [0, 1]
};

inline OpenSurface Mix(const OpenSurface& a, const OpenSurface& b, Lanes part)
{
  return { Mix(static_cast<const Surface&>(a), b, part), Mix(a.open, b.open, part) };
}

inline OpenSurface Select(LaneMask mask, const OpenSurface& yes, const OpenSurface& no)
{
  return { Select(mask, static_cast<const Surface&>(yes), no), Select(mask, yes.open, no.open) };
}

}

}

#endif
