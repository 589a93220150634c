#ifndef Varimarch_Core_Packets_PacketLights_h
#define Varimarch_Core_Packets_PacketLights_h

// Surfaces, and the light of a scene that they reflect to the eye: Shaders/Shade and
// Shaders/Damping.

#include "Core/Packets/Lanes.h"
#include "Core/Packets/PacketScene.h"

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

inline Lanes3 Scaled(const Lanes3& a, const glm::vec3& factors)
{
  return { a.x * factors.x, a.y * factors.y, a.z * factors.z };
}

inline Lanes3 Mix(const Lanes3& a, const Lanes3& b, Lanes part)
{
  return { Mix(a.x, b.x, part), Mix(a.y, b.y, part), Mix(a.z, b.z, part) };
}

inline Surface Mix(const Surface& a, const Surface& b, Lanes part)
{
  return { Mix(a.gradient, b.gradient, part), Mix(a.normalWorld, b.normalWorld, part),
    Mix(a.towardsEye, b.towardsEye, part) };
}

inline Surface Select(LaneMask mask, const Surface& yes, const Surface& no)
{
  const auto select = [&](const Lanes3& a, const Lanes3& b) {
    return Lanes3{ Select(mask, a.x, b.x), Select(mask, a.y, b.y), Select(mask, a.z, b.z) };
  };
  return { select(yes.gradient, no.gradient), select(yes.normalWorld, no.normalWorld),
    Select(mask, yes.towardsEye, no.towardsEye) };
}

/// 1 / length of a surface's normal; 0 for normals whose squared length is next to nothing.
inline Lanes InverseLengthOfNormal(const Surface& surface)
{
  const Lanes squared = Dot(surface.normalWorld, surface.normalWorld);
  return Select(LaneMask(squared > 1e-30f), InverseSqrt(squared), Lanes{});
}

/// Shaders/Damping: the part of the light that a surface receives.
inline Lanes LitPart(const PacketScene& scene, const Surface& surface)
{
  return scene.light.damps
    ? Min(Length(Scaled(surface.gradient, scene.parameters.dampingFactors)), All(1.0f))
    : All(1.0f);
}

/// Shaders/Shade/HeadLight.glsl.
inline Lanes3 LitByHeadLight(const PacketScene& scene, const Lanes3& color, const Surface& surface)
{
  const glm::vec4& reflectance = scene.parameters.reflectances[scene.constituent.component];
  const glm::vec3& diffuseLight = scene.parameters.diffuseLight;
  const glm::vec3& specularLight = scene.parameters.specularLight;
  const Lanes facing = Min(Abs(surface.towardsEye) * InverseLengthOfNormal(surface), All(1.0f));
  const Lanes part = LitPart(scene, surface);
  const Lanes diffuse = part * reflectance.y * facing;
  const Lanes ambient = All(reflectance.x);
  Lanes3 lit{ color.x * (ambient + diffuse * diffuseLight.x),
    color.y * (ambient + diffuse * diffuseLight.y),
    color.z * (ambient + diffuse * diffuseLight.z) };
  if (reflectance.z > 0.0f)
  {
    const Lanes specular = part * reflectance.z * Power(facing, reflectance.w);
    lit = lit +
      Lanes3{ specular * specularLight.x, specular * specularLight.y, specular * specularLight.z };
  }
  return lit;
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
    const Lanes3 outward = -InverseLengthOfNormal(surface) * surface.normalWorld;
    Sum sum = { { Lanes{}, Lanes{}, Lanes{} }, { Lanes{}, Lanes{}, Lanes{} } };
    sum.Add(this->ReflectedFrom(outward, this->toEye), this->parameters.diffuseLight,
      this->parameters.specularLight);
    const glm::vec4* texel = this->scene.light.texels;
    for (int i = 0; i < this->parameters.distantCount; ++i, texel += TexelsPerLight)
    {
      const Lanes3 toLight = { All(texel->x), All(texel->y), All(texel->z) };
      sum.Add(this->ReflectedFrom(outward, toLight), texel[1], texel[2]);
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
  static constexpr float LeastCosine = 1e-6f; // whose powers are still numbers

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

  Lanes Facing(const Lanes3& normal, const Lanes3& direction) const
  {
    const Lanes cosine = Dot(normal, direction);
    return Max(cosine, -this->parameters.backsLit * cosine);
  }

  ReflectedLight ReflectedFrom(const Lanes3& normal, const Lanes3& toLight) const
  {
    const Lanes facing = this->Facing(normal, toLight);
    if (!(this->reflectance.z > 0.0f))
    {
      return { facing, Lanes{} };
    }
    const Lanes3 halfway = toLight + this->toEye;
    const Lanes shining =
      this->Facing(normal, halfway) * InverseSqrt(Max(Dot(halfway, halfway), All(1e-30f)));
    return { facing,
      Select(LaneMask(facing > 0.0f), PowerOf(shining, this->reflectance.w), Lanes{}) };
  }

  ReflectedLight ReflectedFromNear(
    const Lanes3& normal, const Lanes3& positionWorld, const glm::vec4* texel) const
  {
    const Lanes3 place = { All(texel->x), All(texel->y), All(texel->z) };
    const Lanes3 toPlace = place - positionWorld;
    const Lanes distanceMm = Max(Length(toPlace), All(1e-15f));
    const Lanes3 toLight = (1.0f / distanceMm) * toPlace;
    return Reach(texel, distanceMm, toLight) * this->ReflectedFrom(normal, toLight);
  }

  // The part of a near light that reaches a point at this distance.
  static Lanes Reach(const glm::vec4* texel, Lanes distanceMm, const Lanes3& toLight)
  {
    const glm::vec4& attenuation = texel[3];
    const glm::vec4& shinesAlong = texel[4];
    const float cosineOfCone = texel[1].w;
    const float exponent = texel[2].w;
    const Lanes inCone =
      -(toLight.x * shinesAlong.x + toLight.y * shinesAlong.y + toLight.z * shinesAlong.z);
    const Lanes reach =
      1.0f / (attenuation.x + distanceMm * (attenuation.y + distanceMm * attenuation.z));
    const Lanes shaped = exponent == 0.0f ? All(1.0f) : PowerOf(inCone, exponent);
    return Select(LaneMask(inCone >= cosineOfCone), reach * shaped, Lanes{});
  }

  static Lanes PowerOf(Lanes cosine, float exponent)
  {
    return Power(Clamp(cosine, All(LeastCosine), All(1.0f)), exponent);
  }

  const PacketScene& scene;
  const VolumeParameters& parameters;
  const glm::vec4& reflectance;
  Lanes3 toEye;
};

}

}

#endif
