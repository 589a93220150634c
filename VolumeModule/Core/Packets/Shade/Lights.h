#ifndef Varimarch_Core_Packets_Shade_Lights_h
#define Varimarch_Core_Packets_Shade_Lights_h

// Twin of Shade/Lights.glsl.

#include "Core/Packets/Damping/Homogeneous.h"
#include "Core/Packets/Reach/Light.h"
#include "Core/Packets/Shade/HeadLight.h"

namespace varimarch
{

namespace
{

/// Any number of lights, seen from points of the rays of a packet.
class PacketLights
{
public:
  static constexpr int TexelsPerLight = 5;

  PacketLights(const PacketScene& scene, const Lanes4& reflectance, const Lanes3& directionWorld)
    : scene(scene)
    , parameters(scene.parameters)
    , reflectance(reflectance)
    , isShiny(scene.parameters.reflectances[scene.constituent.component].z > 0.0f)
    , toEye(-directionWorld)
  {
  }

  /// @tparam Reach  AllLight or PartialLight
  template <class Reach>
  Lanes3 Lit(const Lanes3& color, const Surface& surface, const Lanes3& positionWorld,
    const Reach& reach) const
  {
    const Lanes3 outward = -InverseLength(surface.normalWorld) * surface.normalWorld;
    Sum sum = { Lanes3(0.0f), Lanes3(0.0f) };
    sum.Add(this->ReflectedFrom(outward, this->toEye), this->parameters.diffuseLight,
      this->parameters.specularLight);
    const glm::vec4* texel = this->scene.textures.lightTexels.Texels<glm::vec4>();
    for (int i = 0; i < this->parameters.distantCount; ++i, texel += TexelsPerLight)
    {
      const Lanes2 reflected = this->ReflectedFrom(outward, AllOf3(*texel));
      sum.Add(Reached(reflected, reach, i), texel[1], texel[2]);
    }
    for (int i = 0; i < this->parameters.nearCount; ++i, texel += TexelsPerLight)
    {
      const Lanes2 reflected = this->ReflectedFromNear(outward, positionWorld, texel);
      sum.Add(Reached(reflected, reach, this->parameters.distantCount + i), texel[1], texel[2]);
    }
    return LitByAll(color, LitPart(this->scene, surface), this->reflectance,
      AllOf3(this->parameters.ambientLight), sum.diffuse, sum.specular);
  }

private:
  struct Sum
  {
    Lanes3 diffuse;
    Lanes3 specular;

    /// @param reflected  the diffuse and the specular part of a light
    void Add(const Lanes2& reflected, const glm::vec3& diffuseColor, const glm::vec3& specularColor)
    {
      this->diffuse = this->diffuse + reflected.x * AllOf3(diffuseColor);
      this->specular = this->specular + reflected.y * AllOf3(specularColor);
    }
  };

  Lanes2 ReflectedFrom(const Lanes3& normal, const Lanes3& toLight) const
  {
    const Lanes backsLit = All(this->parameters.backsLit);
    return this->isShiny ? Reflected(normal, toLight, this->toEye, this->reflectance.w, backsLit)
                         : Lanes2(Facing(normal, toLight, backsLit), Lanes{});
  }

  Lanes2 ReflectedFromNear(
    const Lanes3& normal, const Lanes3& positionWorld, const glm::vec4* texel) const
  {
    const Lanes3 toPlace = AllOf3(texel[0]) - positionWorld;
    const Lanes distanceMm = Max(Length(toPlace), 1e-15f);
    const Lanes3 toLight = (1.0f / distanceMm) * toPlace;
    const Lanes reach = LightReach(
      AllOf3(texel[3]), distanceMm, toLight, AllOf3(texel[4]), All(texel[1].w), All(texel[2].w));
    const Lanes2 reflected = this->ReflectedFrom(normal, toLight);
    return { reach * reflected.x, reach * reflected.y };
  }

  const PacketScene& scene;
  const VolumeParameters& parameters;
  Lanes4 reflectance;
  bool isShiny; ///< True if there is specular light.
  Lanes3 toEye;
};

}

}

#endif
