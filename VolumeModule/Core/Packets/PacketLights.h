#ifndef Varimarch_Core_Packets_PacketLights_h
#define Varimarch_Core_Packets_PacketLights_h

// Surfaces, and the light of a scene that they reflect to the eye: Shaders/Shade and
// Shaders/Damping.

#include "Core/Packets/PacketScene.h"
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

/// Shaders/Damping: the part of the light that a surface receives.
inline Lanes LitPart(const PacketScene& scene, const Surface& surface)
{
  return scene.light.damps ? DampedPart(surface.gradient, AllOf3(scene.parameters.dampingFactors))
                           : All(1.0f);
}

/// The reflectance of a constituent. Without specular light its specular power is 0, which costs
/// nothing.
inline Lanes4 ReflectanceOf(const PacketScene& scene)
{
  const glm::vec4& r = scene.parameters.reflectances[scene.constituent.component];
  return { All(r.x), All(r.y), All(r.z), All(r.z > 0.0f ? r.w : 0.0f) };
}

/// Shaders/Shade/HeadLight.glsl.
inline Lanes3 LitByHeadLight(const PacketScene& scene, const Lanes3& color, const Surface& surface)
{
  return LitFromEye(color, FacingEye(surface.normalWorld, surface.towardsEye),
    LitPart(scene, surface), ReflectanceOf(scene), AllOf3(scene.parameters.diffuseLight),
    AllOf3(scene.parameters.specularLight));
}

/// The parts of a light that a surface reflects to the eye.
struct ReflectedLight
{
  Lanes diffuse;
  Lanes specular;
};

inline ReflectedLight operator*(Lanes factor, const ReflectedLight& a)
{
  return { factor * a.diffuse, factor * a.specular };
}

/// Shaders/Shade/Lights.glsl: any number of lights, seen from points of the rays of a packet.
class PacketLights
{
public:
  PacketLights(const PacketScene& scene, const Lanes3& directionWorld)
    : scene(scene)
    , parameters(scene.parameters)
    , reflectance(scene.parameters.reflectances[scene.constituent.component])
    , toEye{ -directionWorld.x, -directionWorld.y, -directionWorld.z }
  {
  }

  Lanes3 Lit(const Lanes3& color, const Surface& surface, const Lanes3& positionWorld) const
  {
    const Lanes squared = Dot(surface.normalWorld, surface.normalWorld);
    const Lanes inverseLength = Select(LaneMask(squared > 1e-36f), InverseSqrt(squared), Lanes{});
    const Lanes3 outward = -inverseLength * surface.normalWorld;
    Sum sum = { { Lanes{}, Lanes{}, Lanes{} }, { Lanes{}, Lanes{}, Lanes{} } };
    sum.Add(this->ReflectedFrom(outward, this->toEye), this->parameters.diffuseLight,
      this->parameters.specularLight);
    const glm::vec4* texel = this->scene.light.texels;
    for (int i = 0; i < this->parameters.distantCount; ++i, texel += TexelsPerLight)
    {
      sum.Add(this->ReflectedFrom(outward, AllOf3(*texel)), texel[1], texel[2]);
    }
    for (int i = 0; i < this->parameters.nearCount; ++i, texel += TexelsPerLight)
    {
      sum.Add(this->ReflectedFromNear(outward, positionWorld, texel), texel[1], texel[2]);
    }
    const Lanes part = LitPart(this->scene, surface);
    const Lanes diffuse = part * this->reflectance.y;
    const Lanes specular = part * this->reflectance.z;
    const glm::vec3 ambient = this->reflectance.x * glm::vec3(this->parameters.ambientLight);
    return Lanes3{ color.x * (ambient.x + diffuse * sum.diffuse.x),
      color.y * (ambient.y + diffuse * sum.diffuse.y),
      color.z * (ambient.z + diffuse * sum.diffuse.z) } +
      specular * sum.specular;
  }

private:
  static constexpr int TexelsPerLight = 5;

  struct Sum
  {
    Lanes3 diffuse;
    Lanes3 specular;

    void Add(const ReflectedLight& reflected, const glm::vec3& diffuseColor,
      const glm::vec3& specularColor)
    {
      const Lanes a = reflected.diffuse;
      const Lanes b = reflected.specular;
      this->diffuse =
        this->diffuse + Lanes3{ a * diffuseColor.x, a * diffuseColor.y, a * diffuseColor.z };
      this->specular =
        this->specular + Lanes3{ b * specularColor.x, b * specularColor.y, b * specularColor.z };
    }
  };

  ReflectedLight ReflectedFrom(const Lanes3& normal, const Lanes3& toLight) const
  {
    const Lanes backsLit = All(this->parameters.backsLit);
    const Lanes facing = Facing(normal, toLight, backsLit);
    if (!(this->reflectance.z > 0.0f))
    {
      return { facing, Lanes{} };
    }
    const Lanes shining = Shining(normal, toLight, this->toEye, backsLit);
    return { facing,
      Select(LaneMask(facing > 0.0f), Power(shining, this->reflectance.w), Lanes{}) };
  }

  ReflectedLight ReflectedFromNear(
    const Lanes3& normal, const Lanes3& positionWorld, const glm::vec4* texel) const
  {
    const Lanes3 toPlace = AllOf3(texel[0]) - positionWorld;
    const Lanes distanceMm = Max(Length(toPlace), 1e-15f);
    const Lanes3 toLight = (1.0f / distanceMm) * toPlace;
    const Lanes reach = LightReach(
      AllOf3(texel[3]), distanceMm, toLight, AllOf3(texel[4]), All(texel[1].w), All(texel[2].w));
    return reach * this->ReflectedFrom(normal, toLight);
  }

  const PacketScene& scene;
  const VolumeParameters& parameters;
  const glm::vec4& reflectance;
  Lanes3 toEye;
};

}

}

#endif
