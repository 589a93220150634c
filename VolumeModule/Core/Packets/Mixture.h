#ifndef Varimarch_Core_Packets_Mixture_h
#define Varimarch_Core_Packets_Mixture_h

// Several components of a volume, and volumes that overlap, in one march by midpoints.
// Twin of Around/Volumes.glsl, Volumes/Next.glsl, Reading/Cells.glsl, Reading/Voxels.glsl,
// Values/All.glsl, Material/Components.glsl, Outside/Components.glsl,
// Classify/ComponentTables.glsl, Components/Independent.glsl, Components/LuminanceOpacity.glsl,
// Components/Rgba.glsl and March/Several.glsl.

#include "Core/Packets/AnyVoxels.h"
#include "Core/Packets/DimmedMaterial.h"
#include "Core/Packets/PacketTileMarch.h"
#include "Core/Packets/Walk.h"

namespace varimarch
{

namespace
{

// Light in a mixture. The optical depths of its constituents add up along a ray to a light, so that
// the light that reaches a place is the product of what each of them lets through.

/// The part of a light that all constituents let through.
class LightThroughAll
{
public:
  /// @param light  its index
  LightThroughAll(const PacketScene& first, int light)
    : all(first)
    , light(light)
  {
  }

  /// The part at places in the grid of the first constituent. If the light is a point, geometry
  /// leaves all of it, as in TracedLight.
  Lanes At(const Lanes3& placeGrid, LaneMask mask) const
  {
    const Casters casters(this->all[0], this->light);
    const bool hasCasters = Casters::AreIn(this->all[0]);
    return this->ThroughVolumes(placeGrid, mask,
      [&](const auto& turned)
      { return hasCasters ? casters.Leave(placeGrid, mask, turned) : mask; });
  }

  /// The part that the volumes alone let through.
  Lanes ThroughVolumes(const Lanes3& placeGrid, LaneMask mask) const
  {
    return this->ThroughVolumes(placeGrid, mask, [&](const auto&) { return mask; });
  }

private:
  /// @param left  (see ShadowedLight, turned) -> the places that this direction of a cone reaches
  template <class Left>
  Lanes ThroughVolumes(const Lanes3& placeGrid, LaneMask mask, Left left) const
  {
    const float coneHeight = ShadowedLight(this->all[0], this->light).ConeHeight();
    return coneHeight > 0.0f
      ? this->OfConeAt(placeGrid, coneHeight, left)
      : this->ProductAt(placeGrid, mask,
          [](const auto& traced, const Lanes3& place, LaneMask counts, const PacketScene&)
          { return traced.At(place, counts); });
  }

  // A mean of products is no product of means, such as lattices have.
  template <class Left>
  [[gnu::noinline]] Lanes OfConeAt(const Lanes3& placeGrid, float coneHeight, Left left) const
  {
    return MeanOverCone(coneHeight,
      [&](const auto& turned)
      {
        const LaneMask reached = left(turned);
        const Lanes part = this->ProductAt(placeGrid, reached,
          [&](const auto& traced, const Lanes3& place, LaneMask counts, const PacketScene& scene)
          { return traced.Along(place, counts, scene.rays.shadowStepMm, turned); });
        return Select(reached, part, Lanes{});
      });
  }

  /// @param partOf  (TracedLight of a constituent, places in its grid, mask, its scene)
  template <class PartOf>
  Lanes ProductAt(const Lanes3& placeGrid, LaneMask mask, PartOf partOf) const
  {
    const PacketScene& first = this->all[0];
    Lanes part = All(1.0f);
    for (int i = 0; i < this->all.Count(); ++i)
    {
      const LaneMask counts = mask & LaneMask(part > first.shadows.tolerance);
      if (!Any(counts))
      {
        break;
      }
      const PacketScene& scene = this->all[i];
      const TracedLight traced(scene, this->light);
      const Lanes3 place = PlaceInGridOf(scene.parameters, first.parameters, placeGrid);
      part = Select(counts, part * partOf(traced, place, counts, scene), part);
    }
    return part;
  }

  AllConstituents all;
  int light;
};

constexpr int PartsPerSegment = 4;

/// Emission [1/mm] of the parts of a segment by each light, which shadows may take away.
using EmissionByLights = Lanes3[PartsPerSegment][MostShadowedLights];

/// Gathers the light that the parts of segments would emit without shadows, and adds to a sum what
/// shadows leave of it.
class MixedLight
{
public:
  /// @param rays  in the grid of the first constituent
  MixedLight(const PacketScene& first, const PacketRays& rays)
    : first(first)
    , rays(rays)
    , lightCount(ShadowedLight::CountOf(first))
    , casters(first, rays)
    , gathered(this->lightCount, first.rays.shadowStepMm)
  {
  }

  int LightCount() const { return this->lightCount; }

  /// The emission of the next segment, which is 0 so far.
  EmissionByLights& BeginSegment()
  {
    for (auto& part : this->emission)
    {
      for (int light = 0; light < this->lightCount; ++light)
      {
        part[light] = Lanes3(0.0f);
      }
    }
    return this->emission;
  }

  /// See AddInPieces.
  template <class Add>
  static void InPieces(Lanes extinction, const Lanes& transmittance, const RayPart& part, Add add)
  {
    GatheredLight::InPieces(extinction, transmittance, part, add);
  }

  /// Gathers the light of a part of the segment, before it is added to the sum.
  void Gather(PacketSum& sum, int index, const RayPart& part, Lanes extinction)
  {
    const Lanes depth = extinction * part.lengthMm;
    const LaneMask isSeen = LaneMask(depth > 0.0f);
    if (!Any(isSeen))
    {
      return;
    }
    if (this->gathered.IsFullAt(part.t, isSeen, extinction))
    {
      this->AddGathered(sum);
    }
    this->gathered.MoveTo(part.t, isSeen, extinction);
    const Lanes seen = Select(isSeen,
      sum.transmittance * Absorption(Min(depth, All(100.0f))) / Max(extinction, All(1e-30f)),
      Lanes{});
    for (int light = 0; light < this->lightCount; ++light)
    {
      const Lanes left = this->casters.Left(light, seen, part, isSeen);
      this->gathered.Add(light, left * this->emission[index][light]);
    }
  }

  [[gnu::noinline]] void AddGathered(PacketSum& sum)
  {
    const Lanes3 color = this->gathered.Flush(this->first.shadows.tolerance,
      [&](int light, LitPlaces& places)
      {
        const LightThroughAll traced(this->first, light);
        TracedPlaces<LightThroughAll>(this->rays, traced).Set(places);
      });
    sum.color = sum.color + color;
  }

private:
  const PacketScene& first;
  const PacketRays& rays;
  int lightCount; ///< number of lights that cast shadows
  CastersOnRays casters;
  GatheredLight gathered;
  EmissionByLights emission;
};

/// Light where nothing casts shadows.
class UnmixedLight
{
public:
  template <class Add>
  static void InPieces(Lanes, const Lanes&, const RayPart& part, Add add)
  {
    add(part);
  }
  static void Gather(PacketSum&, int, const RayPart&, Lanes) {}
  static void AddGathered(PacketSum&) {}
};

/// A part of a segment.
struct MixedPart
{
  Optical& sum;     ///< emission (as the color) [1/mm] and extinction
  Lanes3* byLights; ///< emission that shadows may take away; null: there are none
  int lightCount;   ///< number of these lights
};

struct MixedSegment
{
  Optical parts[PartsPerSegment] = {};
  EmissionByLights* byLights = nullptr;
  int lightCount = 0;

  MixedPart Part(int part)
  {
    return { this->parts[part], this->byLights ? (*this->byLights)[part] : nullptr,
      this->lightCount };
  }
};

/// A segment in equal parts, each of which has the properties of its middle.
struct PartLanes
{
  Lanes firstMiddle;
  Lanes partMm;

  Lanes MiddleOf(int part) const { return this->firstMiddle + float(part) * this->partMm; }
};

/// Segments of a march without shadows.
inline MixedSegment NextSegment(UnmixedLight&)
{
  return {};
}

inline MixedSegment NextSegment(MixedLight& light)
{
  MixedSegment segment;
  segment.byLights = &light.BeginSegment();
  segment.lightCount = light.LightCount();
  return segment;
}

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

/// Marches all constituents together, from face to face of their boxes, and skips what none of
/// them shows.
/// @param piece  in the grid of the first constituent
/// @param last   the constituent that knows all others
/// @tparam Light  MixedLight or UnmixedLight
template <class Light>
PacketSum MarchTogether(const PacketPiece& piece, Constituent& last, Light light)
{
  const PacketScene& first = piece.scene;
  const PacketRays& rays = piece.rays;
  constexpr float Part = 1.0f / PartsPerSegment;
  const float plainMm = PartsPerSegment * first.rays.stepMm;
  PacketSum sum = piece.before;
  Lanes t = rays.enter;
  LaneMask going = GoOn(first, rays, t, sum);
  for (int index = 0; index < first.rays.mostSegments && Any(going); ++index)
  {
    const SegmentLanes visible = last.NextVisible(t, going);
    const Lanes enter = Min(visible.enter, rays.exit);
    going &= LaneMask(enter < rays.exit);
    if (!Any(going))
    {
      break; // the rest is invisible
    }
    const Lanes plain = enter + piece.walk.StepMm(AllInt(index), plainMm, sum.opticalDepth);
    t = Min(Min(Max(plain, visible.exit), last.NextFace(enter, going)), rays.exit);
    const Lanes partMm = Select(going, (t - enter) * Part, Lanes{});
    const PartLanes parts{ enter + 0.5f * partMm, partMm };
    MixedSegment mixture = NextSegment(light);
    last.AddTo(mixture, parts, going);
    for (int i = 0; i < PartsPerSegment; ++i)
    {
      const Optical& part = mixture.parts[i];
      const Lanes3 color = (1.0f / Max(part.extinction, All(1e-30f))) * part.color;
      light.InPieces(part.extinction, sum.transmittance, { parts.MiddleOf(i), partMm },
        [&](const RayPart& piece)
        {
          light.Gather(sum, i, piece, part.extinction);
          sum.Add({ color, part.extinction }, piece.lengthMm);
        });
    }
    going &= GoOn(first, rays, t, sum);
  }
  light.AddGathered(sum);
  return sum;
}

/// Makes the constituents from the first to the last on the stack, each of which knows the one
/// before it.
inline PacketSum MarchBehind(const PacketPiece& piece, int next, Constituent* known)
{
  const PacketConstituent& all = piece.scene.constituent;
  const PacketScene& scene = next < all.otherCount ? all.others[next] : piece.scene;
  Constituent constituent(scene, piece, known);
  if (next < all.otherCount)
  {
    return MarchBehind(piece, next + 1, &constituent);
  }
  return piece.scene.light.castsShadows
    ? MarchTogether(piece, constituent, MixedLight(piece.scene, piece.rays))
    : MarchTogether(piece, constituent, UnmixedLight());
}

}

}

#endif
