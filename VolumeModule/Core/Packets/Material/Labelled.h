#ifndef Varimarch_Core_Packets_Material_Labelled_h
#define Varimarch_Core_Packets_Material_Labelled_h

// Twin of Material/Labelled.glsl, Classify/LabelTables.glsl, Rows/Tables.glsl and
// Rows/ValueAndGradient.glsl.

#include "Core/Packets/GradientOpacity/LabelTables.h"
#include "Core/Packets/LabelLight/Labels.h"
#include "Core/Packets/Material/OneComponent.h"

namespace varimarch
{

namespace
{

/// A material that depends on the row of a mask that the rays are in.
class LabelledMaterial : public PacketMaterial
{
public:
  LabelledMaterial(const PacketScene& scene, const PacketRays& rays)
    : PacketMaterial(scene, rays)
    , surfaces(scene, rays)
  {
  }

  Optical At(Lanes value, const Surface& surface, Lanes t) const
  {
    const float labelPart = this->scene.parameters.labelPart;
    Optical optical = this->OfRows(this->rays.region, value, surface);
    const LaneMask isMixed = this->rays.region > 0;
    if (labelPart < 1.0f && Any(isMixed))
    {
      const Optical plain = this->OfRows(IntLanes{}, value, surface);
      const Optical mixed = this->Mixed(plain, optical);
      optical.extinction = Select(isMixed, mixed.extinction, optical.extinction);
      optical.color = Select(isMixed, mixed.color, optical.color);
    }
    optical.color = this->Lit(optical.color, surface, t);
    return optical;
  }

private:
  Lanes3 Lit(const Lanes3& color, const Surface& surface, Lanes t) const
  {
    const LaneMask isLabelled = LaneMask(this->rays.region > 0);
    if (!this->scene.light.labels || !Any(isLabelled))
    {
      return this->Shaded(color, surface, t);
    }
    const Lanes3 normal = this->surfaces.GradientAt(this->rays.At(t));
    const LaneMask isInside = isLabelled & LaneMask(Dot(normal, normal) <= LeastSurface);
    const Lanes factor = All(this->scene.parameters.labelGradient);
    const Surface facingEye = { Lanes3(factor), this->directionWorld, All(1.0f) };
    const Surface own = Select(isInside, facingEye, this->SurfaceOf(factor * normal));
    Lanes4 reflectance = ReflectanceOf(this->scene);
    reflectance.z = Select(isInside, All(0.0f), reflectance.z);
    return this->ShadedBy(reflectance, color, Select(isLabelled, own, surface), t);
  }

  Optical OfRows(IntLanes rows, Lanes value, const Surface& surface) const
  {
    Optical optical = this->OfTables(rows, value, surface);
    const LaneMask isPlain = LaneMask(rows == 0);
    if (this->scene.textures.twoValueTable && Any(isPlain))
    {
      const Optical plain = ClassifyTwo(this->scene, value, surface.gradient);
      optical.extinction = Select(isPlain, plain.extinction, optical.extinction);
      optical.color = Select(isPlain, plain.color, optical.color);
    }
    return optical;
  }

  Optical OfTables(IntLanes rows, Lanes value, const Surface& surface) const
  {
    const IntNumbers row(rows);
    const auto lookOf = [&](int lane) -> const PacketRow&
    { return this->scene.labelRows[row.of[lane]]; };
    const Lanes last = LanesOf([&](int lane) { return float(lookOf(lane).lastIndex); });
    const Lanes place =
      TableIndex(value, LanesOf([&](int lane) { return lookOf(lane).indexScale; }),
        LanesOf([&](int lane) { return lookOf(lane).indexOffset; }), last);
    const Lanes below = EntryBelow(place, last);
    const IntNumbers index(Truncated(below));
    const Numbers part(place - below);
    Four entries[LaneCount];
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      entries[lane] = MixedEntries(lookOf(lane).table + index.of[lane], part.of[lane]);
    }
    Optical optical = OpticalOf(entries);
    if (this->scene.textures.gradientOpacityTable)
    {
      optical.extinction = AtGradientOfRows(this->scene, optical.extinction, surface.gradient, row);
    }
    return optical;
  }

  // Mixes colours, and opacities over a unit distance.
  Optical Mixed(const Optical& plain, const Optical& own) const
  {
    const Lanes part = All(this->scene.parameters.labelPart);
    return { Mix(plain.color, own.color, part),
      MixedExtinction(plain.extinction, own.extinction, part,
        All(this->scene.parameters.opacityUnitDistancesMm.x)) };
  }

  LabelSurfaces surfaces;
};

}

}

#endif
