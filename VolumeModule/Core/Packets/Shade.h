#ifndef Varimarch_Core_Packets_Shade_h
#define Varimarch_Core_Packets_Shade_h

// The light that surfaces and matter send to the eye.
// Twin of Damping/Homogeneous.glsl, Scatter/HenyeyGreenstein.glsl, Shade/HeadLight.glsl and
// Shade/Lights.glsl.

#include "Core/Packets/Lanes.h"
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

/// The part of the light that a surface receives.
inline Lanes LitPart(const PacketScene& scene, const Surface& surface)
{
  return scene.light.damps ? DampedPart(surface.gradient, AllOf3(scene.parameters.dampingFactors))
                           : All(1.0f);
}

/// The light that goes to the eye: a part that surfaces reflect, and one that matter scatters.
class ScatteredLight
{
public:
  ScatteredLight(const VolumeParameters& parameters, const Lanes3& toEye)
    : parameters(parameters)
    , toEye(toEye)
  {
  }

  /// @param litPart  the part of the light that surfaces receive
  Lanes BySurfaces(Lanes litPart) const
  {
    return (1.0f - this->parameters.scatteredPart) * litPart;
  }

  Lanes ByMatter(const Lanes3& toLight) const
  {
    return this->parameters.scatteredPart *
      HenyeyGreenstein(-Dot(toLight, this->toEye), All(this->parameters.anisotropy));
  }

private:
  const VolumeParameters& parameters;
  Lanes3 toEye;
};

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

}

}

#endif
