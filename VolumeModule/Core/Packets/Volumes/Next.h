#ifndef Varimarch_Core_Packets_Volumes_Next_h
#define Varimarch_Core_Packets_Volumes_Next_h

// The parts of a mixture: components of a volume, and volumes that overlap.
// Twin of Volumes/Next.glsl, Reading/Cells.glsl, Reading/Voxels.glsl, Values/All.glsl,
// Material/Components.glsl, Classify/ComponentTables.glsl, Components/Independent.glsl,
// Components/LuminanceOpacity.glsl and Components/Rgba.glsl.

#include "Core/Packets/Interpolation/CubicSpline.h"
#include "Core/Packets/Interpolation/Linear.h"
#include "Core/Packets/Loop/Segments.h"
#include "Core/Packets/March/Voxels.h"
#include "Core/Packets/Material/OneComponent.h"
#include "Core/Packets/PacketLattice.h"
#include "Core/Packets/Spacing/Uneven.h"
#include "Core/Packets/Step/OpticalField.h"

namespace varimarch
{

namespace
{

/// Calls a function with a reader for the type of the voxels.
/// @param read  (reader)
template <template <class> class Reader, class Read>
auto ReadByType(const PacketVolume& volume, Read read)
{
  return ByVoxelType(
    volume.type, [&](auto voxel) { return read(Reader<decltype(voxel)>(volume)); });
}

constexpr int PartsPerSegment = 4;

/// Emission (as the color) [1/mm] and extinction of the parts of a segment.
struct MixedSegment
{
  Optical parts[PartsPerSegment] = {};
};

/// A segment in equal parts, each of which has the properties of its middle.
struct PartLanes
{
  Lanes firstMiddle;
  Lanes partMm;

  Lanes MiddleOf(int part) const { return this->firstMiddle + float(part) * this->partMm; }
};

/// A constituent of a mixture, and the ones before it. All have the same rays, each in its own
/// grid; t is a length in the world, and so means the same place for all.
class Constituent
{
public:
  /// @param x, y  the first pixel
  Constituent(
    const PacketScene& scene, const PacketRays& raysOfAll, int x, int y, Constituent* before)
    : before(before)
    , scene(scene)
    , isOfBoxes(scene.rule == PacketRule::MaterialVoxels)
    , rays(OwnRays(scene, raysOfAll, x, y))
    , walk(scene, this->rays, x, y)
    , material(scene, this->rays)
    , lattice(this->rays, 1.0f, -0.5f, scene.volume.voxelCount)
    , box(this->lattice.At(this->rays.enter))
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
    const PacketVolume& volume = this->scene.volume;
    if (this->isOfBoxes)
    {
      ReadByType<PacketBoxes>(
        volume, [&](const auto& boxes) { this->AddBox(boxes, mixture, parts, isIn); });
    }
    else if (volume.areOfSpline)
    {
      this->AddVoxels(PacketSpline(volume), mixture, parts, isIn);
    }
    else
    {
      ReadByType<PacketVoxels>(
        volume, [&](const auto& voxels) { this->AddVoxels(voxels, mixture, parts, isIn); });
    }
  }

private:
  static PacketRays OwnRays(const PacketScene& scene, const PacketRays& raysOfAll, int x, int y)
  {
    const VolumeParameters& own = scene.parameters;
    const PacketDepths& visible = scene.constituent.visible;
    PacketRays rays = InGridOf(own, raysOfAll);
    KeepInside(rays, own.ownLowerGrid, own.ownUpperGrid);
    if (visible.nearest)
    {
      CutByVisible(rays, visible, x, y);
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

  // The place where voxels are read.
  Lanes3 PlaceAt(Lanes t) const { return this->VoxelPlace(this->rays.At(t)); }

  Lanes3 VoxelPlace(const Lanes3& grid) const
  {
    return this->scene.textures.spacingTable ? UnevenPlace(this->scene, grid) : grid;
  }

  template <class Voxels>
  Slope SlopeAt(const Voxels& voxels, Lanes t, LaneMask mask) const
  {
    const Lanes3 grid = this->rays.At(t);
    if (!this->scene.textures.spacingTable)
    {
      return voxels.SlopeAt(grid, mask);
    }
    const auto along = [&](float x, float y, float z)
    {
      const Lanes3 step{ All(x), All(y), All(z) };
      return voxels.ValueAt(this->VoxelPlace(grid + step)) -
        voxels.ValueAt(this->VoxelPlace(grid - step));
    };
    return { voxels.ValueAt(this->VoxelPlace(grid)),
      { along(1.0f, 0.0f, 0.0f), along(0.0f, 1.0f, 0.0f), along(0.0f, 0.0f, 1.0f) } };
  }

  LaneMask Absorbs(Lanes value, LaneMask mask) const
  {
    return mask & MayAbsorb(this->scene.look, value, value);
  }

  void Add(Optical& sum, const Optical& optical, LaneMask mask) const
  {
    const float weight = this->scene.parameters.partWeights[this->scene.constituent.component];
    const Lanes extinction = Select(mask, weight * optical.extinction, Lanes{});
    sum.color = sum.color + extinction * optical.color;
    sum.extinction += extinction;
  }

  // A box has the same properties in all parts.
  template <class Boxes>
  void AddBox(
    const Boxes& boxes, MixedSegment& mixture, const PartLanes& parts, LaneMask mask) const
  {
    Optical inBox = {};
    const Lanes t = parts.MiddleOf(PartsPerSegment / 2);
    const auto valueOf = [&](const Boxes& component) { return component.ValueOf(this->box.cell); };
    const auto gradientOf = [&](const Boxes& component)
    { return component.GradientOf(this->box.cell); };
    const Lanes value = valueOf(boxes);
    const LaneMask absorbs = this->Absorbs(value, mask);
    if (!Any(absorbs))
    {
      return;
    }
    if (this->scene.colors.count > 0)
    {
      this->AddColored(boxes, inBox, t, mask, valueOf, gradientOf);
    }
    else
    {
      const Lanes3 gradient =
        this->material.IsPlain() ? Lanes3{ Lanes{}, Lanes{}, Lanes{} } : gradientOf(boxes);
      this->Add(inBox, this->material.At(value, this->material.SurfaceOf(gradient), t), absorbs);
    }
    for (Optical& part : mixture.parts)
    {
      part.color = part.color + inBox.color;
      part.extinction += inBox.extinction;
    }
  }

  template <class Voxels>
  void AddVoxels(const Voxels& voxels, MixedSegment& mixture, const PartLanes& parts, LaneMask mask)
  {
    if (this->scene.colors.count > 0)
    {
      this->AddColors(voxels, mixture, parts, mask);
      return;
    }
    this->material.IsPlain() ? this->AddValues(voxels, mixture, parts, mask)
                             : this->AddSurfaces(voxels, mixture, parts, mask);
  }

  template <class Voxels>
  void AddValues(
    const Voxels& voxels, MixedSegment& mixture, const PartLanes& parts, LaneMask mask) const
  {
    Lanes values[PartsPerSegment];
    ReadValues(
      voxels, [&](Lanes t) { return this->PlaceAt(t); }, parts.firstMiddle, parts.partMm, values);
    for (int part = 0; part < PartsPerSegment; ++part)
    {
      const LaneMask absorbs = this->Absorbs(values[part], mask);
      if (Any(absorbs))
      {
        this->Add(mixture.parts[part], Classify(this->scene.look, values[part]), absorbs);
      }
    }
  }

  template <class Voxels>
  void AddSurfaces(
    const Voxels& voxels, MixedSegment& mixture, const PartLanes& parts, LaneMask mask)
  {
    for (int part = 0; part < PartsPerSegment; ++part)
    {
      const Lanes t = parts.MiddleOf(part);
      if (!this->isSeen && !Any(this->Absorbs(voxels.ValueAt(this->PlaceAt(t)), mask)))
      {
        continue;
      }
      const Slope slope = this->SlopeAt(voxels, t, mask);
      const LaneMask absorbs = this->Absorbs(slope.value, mask);
      this->isSeen = Any(absorbs);
      if (this->isSeen)
      {
        const Surface surface = this->material.SurfaceOf(slope.gradient);
        this->Add(mixture.parts[part], this->material.At(slope.value, surface, t), absorbs);
      }
    }
  }

  template <class Voxels>
  void AddColors(
    const Voxels& voxels, MixedSegment& mixture, const PartLanes& parts, LaneMask mask) const
  {
    for (int part = 0; part < PartsPerSegment; ++part)
    {
      const Lanes t = parts.MiddleOf(part);
      const Lanes3 place = this->PlaceAt(t);
      this->AddColored(
        voxels, mixture.parts[part], t, mask,
        [&](const Voxels& component) { return component.ValueAt(place); },
        [&](const Voxels& component) { return this->SlopeAt(component, t, mask).gradient; });
    }
  }

  /// Adds, at one place, a material whose colours come from other components than its opacity.
  /// @param voxels  the component of the opacity
  /// @param valueOf, gradientOf  (component), at the place
  template <class Voxels, class ValueOf, class GradientOf>
  void AddColored(const Voxels& voxels, Optical& sum, Lanes t, LaneMask mask, ValueOf valueOf,
    GradientOf gradientOf) const
  {
    const Lanes value = valueOf(voxels);
    const LaneMask absorbs = this->Absorbs(value, mask);
    if (!Any(absorbs))
    {
      return;
    }
    Optical optical = Classify(this->scene.look, value);
    if (this->scene.textures.gradientOpacityTable)
    {
      optical.extinction = AtGradient(this->scene, optical.extinction, gradientOf(voxels));
    }
    optical.color = this->ColorOf<Voxels>(valueOf);
    if (this->scene.light.shading != PacketShading::None)
    {
      const Surface surface = this->material.SurfaceOf(gradientOf(this->ColorVoxels<Voxels>(0)));
      optical.color = this->material.Shaded(optical.color, surface, t);
    }
    this->Add(sum, optical, absorbs);
  }

  template <class Voxels>
  Voxels ColorVoxels(int component) const
  {
    PacketVolume volume = this->scene.volume;
    volume.voxels = this->scene.colors.voxels[component];
    return Voxels(volume);
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
  bool isSeen = false;   ///< the last sample: the next is then read with its gradient at once
};

}

}

#endif
