#ifndef Varimarch_Core_Packets_Material_Labelled_h
#define Varimarch_Core_Packets_Material_Labelled_h

// Twin of Material/Labelled.glsl.

#include "Core/Packets/LabelLight/Labels.h"
#include "Core/Packets/Material/LabelLooks.h"
#include "Core/Packets/Material/OneComponent.h"

namespace varimarch
{

namespace
{

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
