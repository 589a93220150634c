#ifndef Varimarch_Core_Packets_Material_OneComponent_h
#define Varimarch_Core_Packets_Material_OneComponent_h

// The optical properties of places, which may depend on gradients.
// Twin of Material/OneComponent.glsl, Material/ValueAndGradient.glsl and Values/One.glsl.

#include "Core/Packets/Blend/Composite.h"
#include "Core/Packets/Classify/OpticalTable.h"
#include "Core/Packets/ClassifyTwo/Table.h"
#include "Core/Packets/GradientOpacity/Table.h"
#include "Core/Packets/Interpolation/Linear.h"
#include "Core/Packets/PacketRays.h"
#include "Core/Packets/Shade/HeadLight.h"
#include "Core/Packets/Shade/Lights.h"
#include "Core/Packets/ShaderMath.h"

namespace varimarch
{

namespace
{

/// A part of the rays of a packet, which has the optical properties of its middle.
struct RayPart
{
  Lanes t; ///< its middle [mm]
  Lanes lengthMm;
};

/// A surface that light falls on, and its reflectance.
struct Reflector
{
  Surface surface;
  Lanes4 reflectance;
};

/// The optical properties along the rays of a packet.
class PacketMaterial
{
public:
  using SurfaceType = Surface;

  PacketMaterial(const PacketScene& scene, const PacketRays& rays)
    : scene(scene)
    , rays(rays)
    , directionWorld(Transformed(scene.parameters.worldFromGrid, rays.directionGrid))
  {
  }

  /// True if they do not depend on the surface.
  bool IsPlain() const
  {
    return this->scene.light.shading == PacketShading::None &&
      !this->scene.textures.gradientOpacityTable && !this->scene.textures.twoValueTable;
  }

  /// @param gradient  per voxel
  Surface SurfaceOf(const Lanes3& gradient) const
  {
    const Lanes3 normal = Transformed(this->scene.parameters.worldFromGradient, gradient);
    return { gradient, normal, Dot(normal, this->directionWorld) };
  }

  /// @param t  the place along the rays [mm]
  Optical At(Lanes value, const Surface& surface, Lanes t) const
  {
    Optical optical = this->LookOf(value, surface.gradient);
    optical.color = this->Shaded(optical.color, surface, t);
    return optical;
  }

  /// The optical properties without light.
  Optical LookOf(Lanes value, const Lanes3& gradient) const
  {
    Optical optical = this->scene.textures.twoValueTable ? ClassifyTwo(this->scene, value, gradient)
                                                         : Classify(this->scene.look, value);
    if (this->scene.textures.gradientOpacityTable)
    {
      optical.extinction = AtGradient(this->scene, optical.extinction, gradient);
    }
    return optical;
  }

  Lanes3 Shaded(const Lanes3& color, const Surface& surface, Lanes t) const
  {
    return this->ShadedBy(this->ReflectorAt(surface, t), color, t);
  }

  /// The surface that reflects light where the values have one.
  Reflector ReflectorAt(const Surface& surface, Lanes) const
  {
    return { surface, ReflectanceOf(this->scene) };
  }

  /// The places at which surfaces see what is around them: off the side on which there would be
  /// less matter if values went on as they change here.
  Lanes3 OutsideOf(const Slope& slope, const Lanes3& placeGrid) const
  {
    return this->OutsideBy(slope, placeGrid,
      [&](Lanes value) { return this->LookOf(value, slope.gradient).extinction; });
  }

  /// The same with the light of the first lights taken apart, see PacketLights.
  template <class Take>
  Lanes3 LitApart(const Reflector& own, const Lanes3& color, Lanes t, int apart, Take take) const
  {
    return PacketLights(this->scene, own.reflectance, this->directionWorld)
      .LitApart(color, own.surface, this->WorldAt(t), apart, take);
  }

protected:
  template <class Extinction>
  Lanes3 OutsideBy(const Slope& slope, const Lanes3& placeGrid, Extinction extinctionOf) const
  {
    const Lanes change = ChangePerVoxel(slope.gradient);
    return placeGrid +
      WayOutside(
        slope.gradient, extinctionOf(slope.value + change), extinctionOf(slope.value - change));
  }

  Lanes3 ShadedBy(const Reflector& own, const Lanes3& color, Lanes t) const
  {
    switch (this->scene.light.shading)
    {
      case PacketShading::HeadLight:
        return LitByHeadLight(this->scene, own.reflectance, color, own.surface);
      case PacketShading::Lights:
        return LitByLights(
          this->scene, own.reflectance, this->directionWorld, color, own.surface, this->WorldAt(t));
      case PacketShading::None:
        break;
    }
    return color;
  }

  Lanes3 WorldAt(Lanes t) const
  {
    const glm::vec3& origin = this->scene.parameters.worldOfGridOrigin;
    return Transformed(this->scene.parameters.worldFromGrid, this->rays.At(t)) + AllOf3(origin);
  }

  const PacketScene& scene;
  const PacketRays& rays;
  Lanes3 directionWorld;
};

/// The most frequent material, with a head light and nothing else: an image takes a twentieth less
/// time than with PacketMaterial.
class HeadLitMaterial : public PacketMaterial
{
public:
  using PacketMaterial::PacketMaterial;

  static constexpr bool IsPlain() { return false; }

  static bool IsThatOf(const PacketScene& scene)
  {
    return scene.light.shading == PacketShading::HeadLight &&
      !scene.textures.gradientOpacityTable && !scene.textures.twoValueTable;
  }

  Optical At(Lanes value, const Surface& surface, Lanes) const
  {
    Optical optical = Classify(this->scene.look, value);
    optical.color = LitByHeadLight(this->scene, ReflectanceOf(this->scene), optical.color, surface);
    return optical;
  }
};

/// The surface at places of the rays.
/// @param mask  the rays whose surface matters
template <class Material>
Surface SurfaceAt(const Material& material, const Slope& slope, const Lanes3&, LaneMask)
{
  return material.SurfaceOf(slope.gradient);
}

/// Adds a part of the rays to a sum.
template <class Material>
void AddLit(
  PacketSum& sum, Material& material, Lanes value, const Surface& surface, const RayPart& part)
{
  sum.Add(material.At(value, surface, part.t), part.lengthMm);
}

/// Adds light that a material may still owe to a sum at the end of the rays.
template <class Material>
void AddOwed(PacketSum&, Material&)
{
}

}

}

#endif
