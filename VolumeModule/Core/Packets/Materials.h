#ifndef Varimarch_Core_Packets_Materials_h
#define Varimarch_Core_Packets_Materials_h

// The optical properties of places, which may depend on gradients and labels, with their light.
// Twin of Material/OneComponent.glsl, Material/ValueAndGradient.glsl, Values/One.glsl,
// LabelLight/Labels.glsl, LabelLight/Scalars.glsl and Material/Labelled.glsl.

#include "Core/Packets/Looks.h"
#include "Core/Packets/Rays.h"
#include "Core/Packets/Shade.h"
#include "Core/Packets/ShaderMath.h"
#include "Core/Packets/Voxels.h"
#include "Core/Packets/Walk.h"

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
        return PacketLights(this->scene, own.reflectance, this->directionWorld)
          .Lit(color, own.surface, this->WorldAt(t));
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

/// A smaller square of a gradient is rounding.
constexpr float LeastSurface = 1e-6f;

/// The surfaces of the labels in a mask, whose voxels are those of the volume.
class LabelSurfaces
{
public:
  LabelSurfaces(const PacketScene& scene, const PacketRays& rays)
    : texels(scene.textures.maskTexture.Texels<std::uint16_t>())
    , rays(rays)
    , lattice(rays, 1.0f, -0.5f, scene.volume.voxelCount)
  {
  }

  /// The gradient of the part of space that the labels of the rays fill, per voxel.
  Lanes3 GradientAt(const Lanes3& place) const
  {
    const IntLanes reach = this->TexelsAt(Floor(place + 0.5f), 1);
    if (!Any(reach < 3))
    {
      return Lanes3(0.0f);
    }
    const auto along = [&](float x, float y, float z)
    {
      const Lanes3 step = { All(x), All(y), All(z) };
      return this->LabelledPart(place + step) - this->LabelledPart(place - step);
    };
    const Lanes3 gradient = { along(1.0f, 0.0f, 0.0f), along(0.0f, 1.0f, 0.0f),
      along(0.0f, 0.0f, 1.0f) };
    return Select(LaneMask(reach < 3), gradient, Lanes3(0.0f));
  }

  /// The rows of the labels at places.
  IntLanes RowsAt(const Lanes3& place) const { return this->TexelsAt(Floor(place + 0.5f), 0); }

private:
  Lanes LabelledPart(const Lanes3& place) const
  {
    const Lanes3 low = Floor(place);
    const Lanes3 part = place - low;
    Lanes filled = All(0.0f);
    for (int corner = 0; corner < 8; ++corner)
    {
      const bool x = (corner & 1) != 0;
      const bool y = (corner >> 1 & 1) != 0;
      const bool z = corner >> 2 != 0;
      const Lanes weight =
        (x ? part.x : 1.0f - part.x) * (y ? part.y : 1.0f - part.y) * (z ? part.z : 1.0f - part.z);
      const Lanes3 side = { All(float(x)), All(float(y)), All(float(z)) };
      const IntLanes content = this->TexelsAt(low + side, 0);
      filled += Select(LaneMask(content == this->rays.region), weight, All(0.0f));
    }
    return filled;
  }

  IntLanes TexelsAt(const Lanes3& voxel, int which) const
  {
    const IntNumbers index = this->lattice.IndexOf(voxel);
    return IntLanesOf([&](int lane)
      { return std::int32_t(this->texels[2 * std::ptrdiff_t(index.of[lane]) + which]); });
  }

  const std::uint16_t* texels;
  const PacketRays& rays;
  PacketLattice lattice;
};

/// A material that depends on the row of a mask that the rays are in, if the scene has labels.
class LabelledMaterial : public PacketMaterial
{
public:
  LabelledMaterial(const PacketScene& scene, const PacketRays& rays)
    : PacketMaterial(scene, rays)
    , looks(scene)
    , surfaces(scene, rays)
  {
  }

  Optical At(Lanes value, const Surface& surface, Lanes t) const
  {
    Optical optical = this->LookOf(value, surface.gradient);
    optical.color = this->Shaded(optical.color, surface, t);
    return optical;
  }

  Optical LookOf(Lanes value, const Lanes3& gradient) const
  {
    return this->scene.labelRows ? this->looks.Of(this->rays.region, value, gradient)
                                 : PacketMaterial::LookOf(value, gradient);
  }

  Lanes3 Shaded(const Lanes3& color, const Surface& surface, Lanes t) const
  {
    return this->ShadedBy(this->ReflectorAt(surface, t), color, t);
  }

  /// Labels may be lit as their own surfaces.
  Reflector ReflectorAt(const Surface& surface, Lanes t) const
  {
    const LaneMask isLabelled = LaneMask(this->rays.region > 0);
    Reflector own = PacketMaterial::ReflectorAt(surface, t);
    if (!this->HasLabelSurfaces() || !Any(isLabelled))
    {
      return own;
    }
    const Lanes3 normal = this->surfaces.GradientAt(this->rays.At(t));
    const LaneMask isInside = isLabelled & LaneMask(Dot(normal, normal) <= LeastSurface);
    const Lanes factor = All(this->scene.parameters.labelGradient);
    const Surface facingEye = { Lanes3(factor), this->directionWorld, All(1.0f) };
    const Surface ofLabel = Select(isInside, facingEye, this->SurfaceOf(factor * normal));
    own.surface = Select(isLabelled, ofLabel, surface);
    own.reflectance.z = Select(isInside, All(0.0f), own.reflectance.z);
    return own;
  }

  /// The places at which surfaces see what is around them. A label that is lit as its own surface
  /// sees it on the side on which there is less matter; inside a label, that is the place itself.
  template <class Voxels>
  [[gnu::noinline]] Lanes3 OutsideOf(
    const Slope& slope, const Lanes3& placeGrid, const Voxels& voxels) const
  {
    const Lanes3 ofValues = this->OutsideBy(slope, placeGrid,
      [&](Lanes value) { return this->LookOf(value, slope.gradient).extinction; });
    const LaneMask isLabelled = LaneMask(this->rays.region > 0);
    if (!this->HasLabelSurfaces() || !Any(isLabelled))
    {
      return ofValues;
    }
    const Lanes3 inward = this->surfaces.GradientAt(placeGrid);
    const auto extinctionAt = [&](const Lanes3& place)
    {
      return this->looks.Of(this->surfaces.RowsAt(place), voxels.ValueAt(place), slope.gradient)
        .extinction;
    };
    const Lanes3 way = WayOutside(inward, All(0.0f), All(1.0f));
    const Lanes3 ofSurface =
      placeGrid + WayOutside(inward, extinctionAt(placeGrid + way), extinctionAt(placeGrid - way));
    const Lanes3 ofLabel =
      Select(LaneMask(Dot(inward, inward) > LeastSurface), ofSurface, placeGrid);
    return Select(isLabelled, ofLabel, ofValues);
  }

private:
  bool HasLabelSurfaces() const { return this->scene.labelRows && this->scene.light.labels; }

  LabelLooks looks;
  LabelSurfaces surfaces;
};

}

}

#endif
