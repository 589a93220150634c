#ifndef Varimarch_Core_Packets_Shade_Lights_h
#define Varimarch_Core_Packets_Shade_Lights_h

// Twin of Shade/Lights.glsl.

#include "Core/Packets/Damping/Homogeneous.h"

namespace varimarch
{

namespace
{

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

/// Any number of lights, seen from points of the rays of a packet.
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
