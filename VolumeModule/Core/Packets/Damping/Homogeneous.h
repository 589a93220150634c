#ifndef Varimarch_Core_Packets_Damping_Homogeneous_h
#define Varimarch_Core_Packets_Damping_Homogeneous_h

// Twin of Damping/Homogeneous.glsl.

#include "Core/Packets/PacketScene.h"
#include "Core/Packets/PacketSurface.h"

namespace varimarch
{

namespace
{

/// The part of the light that a surface receives.
inline Lanes LitPart(const PacketScene& scene, const Surface& surface)
{
  return scene.light.damps ? DampedPart(surface.gradient, AllOf3(scene.parameters.dampingFactors))
                           : All(1.0f);
}

}

}

#endif
