#ifndef Varimarch_Core_Packets_Shade_Lights_h
#define Varimarch_Core_Packets_Shade_Lights_h

// Twin of Shade/Lights.glsl.

#include "Core/Packets/Damping/Homogeneous.h"
#include "Core/Packets/Flattened.h"
#include "Core/Packets/Scatter/HenyeyGreenstein.h"
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

  Lanes3 Lit(const Lanes3& color, const Surface& surface, const Lanes3& positionWorld) const
  {
    return this->LitApart(color, surface, positionWorld, 0, [](int, const Lanes3&) {});
  }

  /// The light of all but the first lights, each of which is taken by itself.
  /// @param apart  number of the first lights
  /// @param take   (index of a light, its part of the colour)
  template <class Take>
  Lanes3 LitApart(const Lanes3& color, const Surface& surface, const Lanes3& positionWorld,
    int apart, Take take) const
  {
    if (this->scene.light.scatters)
    {
      return this->SentApart(color, surface, positionWorld, apart, take);
    }
    const Lanes3 outward = -InverseLength(surface.normalWorld) * surface.normalWorld;
    const Lanes litPart = LitPart(this->scene, surface);
    Sum sum = { Lanes3(0.0f), Lanes3(0.0f) };
    sum.Add(this->ReflectedFrom(outward, this->toEye), this->parameters.diffuseLight,
      this->parameters.specularLight);
    const glm::vec4* texel = this->scene.textures.lightTexels.Texels<glm::vec4>();
    const int count = this->parameters.distantCount + this->parameters.nearCount;
    for (int i = 0; i < count; ++i, texel += TexelsPerLight)
    {
      const Incident light = this->IncidentFrom(i, positionWorld, texel);
      const Lanes2 whole = this->ReflectedFrom(outward, light.towards);
      const Lanes2 reflected{ light.strength * whole.x, light.strength * whole.y };
      Sum own = { Lanes3(0.0f), Lanes3(0.0f) };
      this->AddReflected(reflected, texel, i < apart ? &own : nullptr, sum);
      if (i < apart)
      {
        take(
          i, LitByAll(color, litPart, this->reflectance, Lanes3(0.0f), own.diffuse, own.specular));
      }
    }
    return LitByAll(color, litPart, this->reflectance, AllOf3(this->parameters.ambientLight),
      sum.diffuse, sum.specular);
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

  /// The light of a lamp at a point.
  struct Incident
  {
    Lanes3 towards;
    Lanes strength;
  };

  Incident IncidentFrom(int light, const Lanes3& positionWorld, const glm::vec4* texel) const
  {
    if (light < this->parameters.distantCount)
    {
      return { AllOf3(texel[0]), All(1.0f) };
    }
    const Lanes3 toPlace = AllOf3(texel[0]) - positionWorld;
    const Lanes distanceMm = Max(Length(toPlace), 1e-15f);
    const Lanes3 toLight = (1.0f / distanceMm) * toPlace;
    return { toLight,
      LightReach(AllOf3(texel[3]), distanceMm, toLight, AllOf3(texel[4]), All(texel[1].w),
        All(texel[2].w)) };
  }

  // Adds the light of a lamp on surfaces: to its own sum what may be in shadow, to the others' the
  // rest.
  // @param own  null: it casts no shadow
  void AddReflected(const Lanes2& reflected, const glm::vec4* texel, Sum* own, Sum& sum) const
  {
    const float inShadow = own ? this->parameters.surfacesInShadow : 0.0f;
    if (own)
    {
      own->Add({ inShadow * reflected.x, inShadow * reflected.y }, texel[1], texel[2]);
    }
    if (inShadow < 1.0f)
    {
      const float rest = 1.0f - inShadow;
      sum.Add({ rest * reflected.x, rest * reflected.y }, texel[1], texel[2]);
    }
  }

  // LitApart() with light that matter scatters.
  template <class Take>
  Lanes3 SentApart(const Lanes3& color, const Surface& surface, const Lanes3& positionWorld,
    int apart, Take take) const
  {
    const ScatteredLight scattered(this->parameters, this->toEye);
    const Lanes3 outward = -InverseLength(surface.normalWorld) * surface.normalWorld;
    const Lanes bySurfaces = scattered.BySurfaces(LitPart(this->scene, surface));
    const Lanes3 none(0.0f);
    Sum sum = { none, none };
    const Lanes2 atEye = this->ReflectedFrom(outward, this->toEye);
    sum.Add({ bySurfaces * atEye.x + scattered.ByMatter(this->toEye), bySurfaces * atEye.y },
      this->parameters.diffuseLight, this->parameters.specularLight);
    const glm::vec4* texel = this->scene.textures.lightTexels.Texels<glm::vec4>();
    const int count = this->parameters.distantCount + this->parameters.nearCount;
    for (int i = 0; i < count; ++i, texel += TexelsPerLight)
    {
      const Incident light = this->IncidentFrom(i, positionWorld, texel);
      const Lanes2 reflected = this->ReflectedFrom(outward, light.towards);
      const Lanes part = light.strength * bySurfaces;
      Sum own = { none, none };
      Sum& ofMatter = i < apart ? own : sum;
      this->AddReflected(
        { part * reflected.x, part * reflected.y }, texel, i < apart ? &own : nullptr, sum);
      ofMatter.Add(
        { light.strength * scattered.ByMatter(light.towards), Lanes{} }, texel[1], texel[2]);
      if (i < apart)
      {
        take(i, LitByAll(color, All(1.0f), this->reflectance, none, own.diffuse, own.specular));
      }
    }
    return LitByAll(color, All(1.0f), this->reflectance, AllOf3(this->parameters.ambientLight),
      sum.diffuse, sum.specular);
  }

  Lanes2 ReflectedFrom(const Lanes3& normal, const Lanes3& toLight) const
  {
    const Lanes backsLit = All(this->parameters.backsLit);
    return this->isShiny ? Reflected(normal, toLight, this->toEye, this->reflectance.w, backsLit)
                         : Lanes2(Facing(normal, toLight, backsLit), Lanes{});
  }

  const PacketScene& scene;
  const VolumeParameters& parameters;
  Lanes4 reflectance;
  bool isShiny; ///< True if there is specular light.
  Lanes3 toEye;
};

/// The light of all. Its arguments are copies, so that those of a march stay in registers.
[[gnu::noinline]] FLATTENED inline Lanes3 LitByLights(const PacketScene& scene, Lanes4 reflectance,
  Lanes3 directionWorld, Lanes3 color, Surface surface, Lanes3 positionWorld)
{
  return PacketLights(scene, reflectance, directionWorld).Lit(color, surface, positionWorld);
}

}

}

#endif
