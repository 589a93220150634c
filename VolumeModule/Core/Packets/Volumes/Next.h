#ifndef Varimarch_Core_Packets_Volumes_Next_h
#define Varimarch_Core_Packets_Volumes_Next_h

// The parts of a mixture: components of a volume, and volumes that overlap.
// Twin of Volumes/Next.glsl, Reading/Cells.glsl, Reading/Voxels.glsl, Values/All.glsl,
// Material/Components.glsl, Outside/Components.glsl, Classify/ComponentTables.glsl,
// Components/Independent.glsl, Components/LuminanceOpacity.glsl and Components/Rgba.glsl.

#include "Core/Packets/Interpolation/AnyVoxels.h"
#include "Core/Packets/Loop/Segments.h"
#include "Core/Packets/PacketLattice.h"
#include "Core/Packets/PacketTileMarch.h"
#include "Core/Packets/Step/OpticalField.h"
#include "Core/Packets/Volumes/MixedSegment.h"

namespace varimarch
{

namespace
{

/// A constituent of a mixture, and the ones before it. All have the same rays, each in its own
/// grid; t is a length in the world, and so means the same place for all.
class Constituent
{
public:
  /// @param piece  in the grid of the first constituent
  Constituent(const PacketScene& scene, const PacketPiece& piece, Constituent* before)
    : before(before)
    , scene(scene)
    , isOfBoxes(scene.rule == PacketRule::MaterialVoxels)
    , rays(OwnRays(scene, piece))
    , walk(scene, this->rays, piece.x, piece.y)
    , material(scene, this->rays)
    , lattice(this->rays, 1.0f, -0.5f, scene.volume.voxelCount)
    , box(this->lattice.At(this->rays.enter))
    , sky(scene, piece.scene)
  {
  }
  Constituent(const Constituent&) = delete;
  Constituent& operator=(const Constituent&) = delete;

  /// The next segment in which any constituent may be visible, up to where all look the same; Never
  /// for a ray without one.
  [[gnu::flatten]] SegmentLanes NextVisible(Lanes t, LaneMask mask) const
  {
    const SegmentLanes others =
      this->before ? this->before->NextVisible(t, mask) : SegmentLanes{ All(Never), All(Never) };
    if (this->scene.constituent.isOfSameBricks)
    {
      return others;
    }
    SegmentLanes own{ All(Never), All(Never) };
    const Lanes from = Max(t, this->rays.enter);
    const LaneMask meets = mask & LaneMask(from < this->rays.exit);
    if (Any(meets))
    {
      const SegmentLanes next = this->walk.NextOfBricks(from, Lanes{}, meets);
      const LaneMask isAhead = meets & LaneMask(next.enter < this->rays.exit);
      own.enter = Select(isAhead, next.enter, own.enter);
      own.exit = Select(isAhead, next.exit, own.exit);
    }
    // The segment ends at the latest where another constituent becomes visible.
    const Lanes enter = Min(others.enter, own.enter);
    return { enter,
      Min(Select(LaneMask(others.enter > enter), others.enter, others.exit),
        Select(LaneMask(own.enter > enter), own.enter, own.exit)) };
  }

  /// The next place where the properties of any constituent jump, for the rays of a mask.
  Lanes NextFace(Lanes t, LaneMask mask)
  {
    Lanes face = Select(LaneMask(this->rays.enter > t), this->rays.enter, this->rays.exit);
    const LaneMask isIn = mask & LaneMask(t >= this->rays.enter) & LaneMask(t < this->rays.exit);
    if (this->isOfBoxes && Any(isIn))
    {
      face = Select(isIn, Min(face, this->NextFaceOfBox(t, isIn)), face);
    }
    const Lanes ahead = Select(LaneMask(face > t), face, All(Never));
    return this->before ? Min(this->before->NextFace(t, mask), ahead) : ahead;
  }

  /// @param parts  those of a segment without a face in it
  /// @param mask   the rays that count
  void AddTo(MixedSegment& mixture, const PartLanes& parts, LaneMask mask)
  {
    if (this->before)
    {
      this->before->AddTo(mixture, parts, mask);
    }
    const LaneMask isIn = mask & LaneMask(parts.firstMiddle > this->rays.enter) &
      LaneMask(parts.firstMiddle < this->rays.exit);
    if (!Any(isIn))
    {
      return;
    }
    if (this->isOfBoxes)
    {
      this->AddBox(AnyBoxes(this->scene), mixture, parts, isIn);
    }
    else
    {
      this->AddVoxels(AnyVoxels(this->scene), mixture, parts, isIn);
    }
  }

private:
  static PacketRays OwnRays(const PacketScene& scene, const PacketPiece& piece)
  {
    const VolumeParameters& own = scene.parameters;
    const PacketDepths& visible = scene.constituent.visible;
    PacketRays rays = InGridOf(own, piece.rays);
    KeepInside(rays, own.ownLowerGrid, own.ownUpperGrid);
    if (visible.nearest)
    {
      CutByVisible(rays, visible, piece.x, piece.y);
    }
    const LaneMask meets = LaneMask(rays.enter < rays.exit);
    rays.enter = Select(meets, rays.enter, All(Never));
    rays.exit = Select(meets, rays.exit, All(-Never));
    return rays;
  }

  // Advances to the box that contains t.
  Lanes NextFaceOfBox(Lanes t, LaneMask mask)
  {
    LatticePlace behind = this->lattice.Behind(this->box);
    this->box = Select(mask & LaneMask(behind.t < t), this->lattice.At(t), this->box);
    behind = this->lattice.Behind(this->box);
    // At an edge or a corner a ray leaves several boxes at once.
    for (LaneMask leaves = mask & LaneMask(behind.t <= t); Any(leaves);
         leaves &= LaneMask(behind.t <= t))
    {
      this->box = Select(leaves, behind, this->box);
      behind = this->lattice.Behind(this->box);
    }
    return behind.t;
  }

  LaneMask Absorbs(Lanes value, LaneMask mask) const
  {
    return mask & MayAbsorb(this->scene.look, value, value);
  }

  bool IsPlain() const { return this->material.IsPlain() && !(this->scene.sky.strength > 0.0f); }

  // The extinction as a part of the mixture.
  Lanes Mixed(Lanes extinction, LaneMask mask) const
  {
    const float weight = this->scene.parameters.partWeights[this->scene.constituent.component];
    return Select(mask, Min(weight * extinction, All(this->scene.shadows.mostExtinction)), Lanes{});
  }

  static void Add(Optical& sum, const Lanes3& color, Lanes extinction)
  {
    sum.color = sum.color + extinction * color;
    sum.extinction += extinction;
  }

  /// Adds a surface, lit.
  /// @param open  the part of its light that it keeps
  void AddLit(const MixedPart& part, const Optical& look, const Surface& surface, Lanes open,
    Lanes t, LaneMask mask) const
  {
    const Lanes extinction = this->Mixed(look.extinction, mask);
    const Lanes lit = open * extinction;
    const bool mayBeInShadow = part.byLights && this->scene.light.shading == PacketShading::Lights;
    const Lanes3 color = mayBeInShadow
      ? this->material.LitApart(this->material.ReflectorAt(surface, t), look.color, t,
          part.lightCount,
          [&](int light, const Lanes3& own)
          { part.byLights[light] = part.byLights[light] + lit * own; })
      : this->material.Shaded(look.color, surface, t);
    Add(part.sum, open * color, extinction);
  }

  // The part of its light that a surface keeps under ambient occlusion. A box has that of its
  // middle.
  Lanes OpenAt(const Slope& slope, Lanes t, LaneMask mask) const
  {
    if (!(this->scene.sky.strength > 0.0f))
    {
      return All(1.0f);
    }
    return this->sky.At(
      this->material.OutsideOf(slope, this->isOfBoxes ? this->box.cell : this->rays.At(t)), mask);
  }

  // A box has the same properties in all parts.
  void AddBox(
    const AnyBoxes& boxes, MixedSegment& mixture, const PartLanes& parts, LaneMask mask) const
  {
    const auto valueOf = [&](const AnyBoxes& component)
    { return component.ValueOf(this->box.cell); };
    const auto gradientOf = [&](const AnyBoxes& component)
    { return component.GradientOf(this->box.cell); };
    const Lanes value = valueOf(boxes);
    const LaneMask absorbs = this->Absorbs(value, mask);
    if (!Any(absorbs))
    {
      return;
    }
    Optical inBox = {};
    Lanes3 byLights[MostShadowedLights];
    for (int light = 0; light < mixture.lightCount; ++light)
    {
      byLights[light] = Lanes3(0.0f);
    }
    const MixedPart part{ inBox, mixture.byLights ? byLights : nullptr, mixture.lightCount };
    const Lanes t = parts.MiddleOf(PartsPerSegment / 2);
    if (this->scene.colors.count > 0)
    {
      this->AddColored(boxes, part, t, mask, valueOf, gradientOf);
    }
    else
    {
      const Lanes3 none(0.0f);
      this->AddSurface({ value, this->IsPlain() ? none : gradientOf(boxes) }, part, t, absorbs);
    }
    this->AddToAll(part, mixture);
  }

  static void AddToAll(const MixedPart& inBox, MixedSegment& mixture)
  {
    for (int i = 0; i < PartsPerSegment; ++i)
    {
      const MixedPart part = mixture.Part(i);
      part.sum.color = part.sum.color + inBox.sum.color;
      part.sum.extinction += inBox.sum.extinction;
      for (int light = 0; light < inBox.lightCount; ++light)
      {
        part.byLights[light] = part.byLights[light] + inBox.byLights[light];
      }
    }
  }

  void AddVoxels(
    const AnyVoxels& voxels, MixedSegment& mixture, const PartLanes& parts, LaneMask mask)
  {
    if (this->scene.colors.count > 0)
    {
      this->AddColors(voxels, mixture, parts, mask);
      return;
    }
    this->IsPlain() ? this->AddValues(voxels, mixture, parts, mask)
                    : this->AddSurfaces(voxels, mixture, parts, mask);
  }

  void AddValues(
    const AnyVoxels& voxels, MixedSegment& mixture, const PartLanes& parts, LaneMask mask) const
  {
    Lanes values[PartsPerSegment];
    ReadValues(voxels, this->rays, parts.firstMiddle, parts.partMm, values);
    for (int part = 0; part < PartsPerSegment; ++part)
    {
      const LaneMask absorbs = this->Absorbs(values[part], mask);
      if (Any(absorbs))
      {
        const Optical look = Classify(this->scene.look, values[part]);
        Add(mixture.parts[part], look.color, this->Mixed(look.extinction, absorbs));
      }
    }
  }

  void AddSurfaces(
    const AnyVoxels& voxels, MixedSegment& mixture, const PartLanes& parts, LaneMask mask)
  {
    for (int part = 0; part < PartsPerSegment; ++part)
    {
      const Lanes t = parts.MiddleOf(part);
      if (!this->isSeen && !Any(this->Absorbs(voxels.ValueAt(this->rays.At(t)), mask)))
      {
        continue;
      }
      const Slope slope = voxels.SlopeAt(this->rays.At(t), mask);
      const LaneMask absorbs = this->Absorbs(slope.value, mask);
      this->isSeen = Any(absorbs);
      if (this->isSeen)
      {
        this->AddSurface(slope, mixture.Part(part), t, absorbs);
      }
    }
  }

  void AddSurface(const Slope& slope, const MixedPart& part, Lanes t, LaneMask absorbs) const
  {
    this->AddLit(part, this->material.LookOf(slope.value, slope.gradient),
      this->material.SurfaceOf(slope.gradient), this->OpenAt(slope, t, absorbs), t, absorbs);
  }

  void AddColors(
    const AnyVoxels& voxels, MixedSegment& mixture, const PartLanes& parts, LaneMask mask) const
  {
    for (int part = 0; part < PartsPerSegment; ++part)
    {
      const Lanes t = parts.MiddleOf(part);
      const Lanes3 place = this->rays.At(t);
      this->AddColored(
        voxels, mixture.Part(part), t, mask,
        [&](const AnyVoxels& component) { return component.ValueAt(place); },
        [&](const AnyVoxels& component) { return component.SlopeAt(place, mask).gradient; });
    }
  }

  /// Adds, at one place, a material whose colours come from other components than its opacity.
  /// @param voxels  the component of the opacity
  /// @param valueOf, gradientOf  (component), at the place
  template <class Voxels, class ValueOf, class GradientOf>
  void AddColored(const Voxels& voxels, const MixedPart& part, Lanes t, LaneMask mask,
    ValueOf valueOf, GradientOf gradientOf) const
  {
    const Lanes value = valueOf(voxels);
    const LaneMask absorbs = this->Absorbs(value, mask);
    if (!Any(absorbs))
    {
      return;
    }
    const bool hasSurface =
      this->scene.textures.gradientOpacityTable || this->scene.sky.strength > 0.0f;
    const Slope slope{ value, hasSurface ? gradientOf(voxels) : Lanes3(0.0f) };
    Optical look = this->material.LookOf(value, slope.gradient);
    look.color = this->ColorOf<Voxels>(valueOf);
    const bool isLit = this->scene.light.shading != PacketShading::None;
    const Surface surface =
      this->material.SurfaceOf(isLit ? gradientOf(this->ColorVoxels<Voxels>(0)) : Lanes3(0.0f));
    this->AddLit(part, look, surface, this->OpenAt(slope, t, absorbs), t, absorbs);
  }

  template <class Voxels>
  Voxels ColorVoxels(int component) const
  {
    return Voxels(this->scene, this->scene.colors.voxels[component]);
  }

  template <class Voxels, class ValueOf>
  Lanes3 ColorOf(ValueOf valueOf) const
  {
    const PacketColors& colors = this->scene.colors;
    if (colors.count == 1)
    {
      return Classify(colors.look, valueOf(this->ColorVoxels<Voxels>(0))).color;
    }
    const auto color = [&](int component)
    {
      return Clamp(valueOf(this->ColorVoxels<Voxels>(component)) *
          this->scene.parameters.colorScale[component],
        Lanes{}, All(1.0f));
    };
    return { color(0), color(1), color(2) };
  }

  Constituent* before;
  const PacketScene& scene;
  bool isOfBoxes;
  PacketRays rays; ///< in its own grid, cut to its box; Never for rays outside
  PacketWalk walk;
  PacketMaterial material;
  PacketLattice lattice; ///< lattice of boxes
  LatticePlace box;      ///< the one that contains the segment
  mutable OpenSky sky;   ///< follows the places along the rays
  bool isSeen = false;   ///< the last sample: the next is then read with its gradient at once
};

}

}

#endif
