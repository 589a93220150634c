#ifndef Varimarch_Core_Packets_Shade_HeadLight_h
#define Varimarch_Core_Packets_Shade_HeadLight_h

// Twin of Shade/HeadLight.glsl.

#include "Core/Packets/Damping/Homogeneous.h"

namespace varimarch
{

namespace
{

/// The reflectance of a constituent. Without specular light its specular power is 0, which costs
/// nothing.
inline Lanes4 ReflectanceOf(const PacketScene& scene)
{
  const glm::vec4& r = scene.parameters.reflectances[scene.constituent.component];
  return { All(r.x), All(r.y), All(r.z), All(r.z > 0.0f ? r.w : 0.0f) };
}

inline Lanes3 LitByHeadLight(
  const PacketScene& scene, const Lanes4& reflectance, const Lanes3& color, const Surface& surface)
{
  return LitFromEye(color, FacingEye(surface.normalWorld, surface.towardsEye),
    LitPart(scene, surface), reflectance, AllOf3(scene.parameters.diffuseLight),
    AllOf3(scene.parameters.specularLight));
}

}

}

#endif
