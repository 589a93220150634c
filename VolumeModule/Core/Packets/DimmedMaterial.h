#ifndef Varimarch_Core_Packets_DimmedMaterial_h
#define Varimarch_Core_Packets_DimmedMaterial_h

// The material of a volume that dims its own light, by shadows and by ambient occlusion, and the
// light that a volume lets through to places around it.

#include "Core/Packets/Casters.h"
#include "Core/Packets/GatheredLight.h"
#include "Core/Packets/Lanes.h"
#include "Core/Packets/LightRays.h"
#include "Core/Packets/Materials.h"
#include "Core/Packets/SkyLight.h"

#include <cstddef>

namespace varimarch
{

namespace
{

static_assert(MostShadows == MostShadowedLights);

/// The part of a light that reaches places in a volume. If the light is a point, geometry leaves
/// all of it: its shadows have edges, which DimmedMaterial finds.
class TracedLight
{
public:
  /// @param light  its index
  TracedLight(const PacketScene& scene, int light)
    : scene(scene)
    , light(scene, light)
    , casters(scene, light)
    , cells(scene.shadows.nodes[light], scene.shadows.shape)
  {
  }

  Lanes At(const Lanes3& placeGrid, LaneMask mask) const
  {
    return this->IsSoft() && Casters::AreIn(this->scene) ? this->LeftOfConeAt(placeGrid, mask)
                                                         : this->ThroughVolume(placeGrid, mask);
  }

  /// The part that the volume alone lets through.
  Lanes ThroughVolume(const Lanes3& placeGrid, LaneMask mask) const
  {
    return this->IsSoft() ? this->OfConeAt(placeGrid, mask) : this->OfPointAt(placeGrid, mask);
  }

  bool IsSoft() const { return this->light.ConeHeight() > 0.0f; }

  /// The part that the volume lets through from one direction, without the lattice.
  /// @param turned  see ShadowedLight
  template <class Turned>
  Lanes Along(const Lanes3& placeGrid, LaneMask mask, float longestMm, Turned turned) const
  {
    const PacketRays rays = this->light.RaysFrom(placeGrid, turned);
    return this->AtEndOf(rays, mask, longestMm, KnownDepths(rays));
  }

  /// See DepthOfCells. Where the nodes of a cell agree, they tell the light at the end of a ray.
  KnownDepth DepthOf(const Lanes3& placeGrid, Lanes depth, LaneMask mask, Lanes taken) const
  {
    mask &= this->cells.Contains(placeGrid);
    if (!Any(mask))
    {
      return { mask, depth };
    }
    const LightInCells found = this->cells.LightAt(placeGrid, mask,
      [&](const Lanes3& nodeGrid, LaneMask nodes) { return this->AtNode(nodeGrid, nodes); });
    const LaneMask agrees = mask & this->Agrees(found, taken, Exp(-depth));
    return { agrees, depth - Select(agrees, Log(Max(found.between, 1e-6f)), Lanes{}) };
  }

private:
  // Directions are traced one by one only where geometry hides some of them.
  [[gnu::noinline]] Lanes LeftOfConeAt(const Lanes3& placeGrid, LaneMask mask) const
  {
    constexpr float Nothing = 1e-4f; // less than the weight of any direction
    const Lanes left = this->casters.PartOfCone(placeGrid, mask);
    const LaneMask isWhole = mask & LaneMask(left > 1.0f - Nothing);
    const LaneMask isPart = mask & ~isWhole & LaneMask(left > Nothing);
    Lanes light = {};
    if (Any(isWhole))
    {
      light = Select(isWhole, this->OfConeAt(placeGrid, isWhole), light);
    }
    if (Any(isPart))
    {
      const Lanes part = MeanOverCone(this->light.ConeHeight(),
        [&](const auto& turned)
        {
          const LaneMask leaves = this->casters.Leave(placeGrid, isPart, turned);
          return Select(
            leaves, this->Along(placeGrid, leaves, this->scene.rays.shadowStepMm, turned), Lanes{});
        });
      light = Select(isPart, part, light);
    }
    return light;
  }

  Lanes OfPointAt(const Lanes3& placeGrid, LaneMask mask) const
  {
    const PacketRays rays = this->light.RaysFrom(placeGrid);
    return this->AtEndOf(rays, mask, this->scene.rays.shadowStepMm,
      this->cells ? KnownDepths(*this, rays, this->CellMm(rays)) : KnownDepths(rays));
  }

  // Where the nodes of a cell agree, they tell the light; elsewhere all directions are traced.
  [[gnu::noinline]] Lanes OfConeAt(const Lanes3& placeGrid, LaneMask mask) const
  {
    if (!this->cells)
    {
      return this->TracedCone(placeGrid, mask, this->scene.rays.shadowStepMm);
    }
    LaneMask agrees = mask & this->cells.Contains(placeGrid);
    const LightInCells found = this->cells.LightAt(placeGrid, agrees,
      [&](const Lanes3& nodeGrid, LaneMask nodes) { return this->AtNode(nodeGrid, nodes); });
    agrees &= this->Agrees(found, this->TakenBy(placeGrid, agrees));
    const LaneMask others = mask & ~agrees;
    return Any(others)
      ? Select(
          others, this->TracedCone(placeGrid, others, this->scene.rays.shadowStepMm), found.between)
      : found.between;
  }

  [[gnu::noinline]] Lanes TracedCone(const Lanes3& placeGrid, LaneMask mask, float longestMm) const
  {
    return MeanOverCone(this->light.ConeHeight(),
      [&](const auto& turned) { return this->Along(placeGrid, mask, longestMm, turned); });
  }

  // The depth beyond which all light that is left may be missing.
  float MostDepth() const
  {
    return this->scene.shadows.tolerance > 0.0f ? -__builtin_logf(this->scene.shadows.tolerance)
                                                : float(MostShadowDepth);
  }

  Lanes AtEndOf(
    const PacketRays& rays, LaneMask mask, float longestMm, const KnownDepths& known) const
  {
    const ShadowMarch march = { longestMm, FirstShadowStep(All(longestMm)), this->MostDepth() };
    return Exp(-DepthAlong(this->scene, rays, march, mask, known));
  }

  // The length of a cell along rays.
  Lanes CellMm(const PacketRays& rays) const
  {
    return float(this->scene.shadows.shape.voxelsPerNode) / Length(rays.directionGrid);
  }

  // The optical depth of a cell that is filled by the matter at a place.
  Lanes TakenBy(const Lanes3& placeGrid, LaneMask mask) const
  {
    const PacketRays rays = this->light.RaysFrom(placeGrid);
    return this->CellMm(rays) * ExtinctionAt(this->scene, rays, mask);
  }

  // True where the nodes of a cell tell the light at a place. Matter that is thinner than a cell
  // may lie between nodes, which then agree on light that it takes.
  // @param taken  the optical depth of a cell that is filled by the matter at the place
  LaneMask Agrees(const LightInCells& found, Lanes taken, Lanes left = All(1.0f)) const
  {
    return LaneMask(
      left * Max(found.spread, found.between * taken) <= this->scene.shadows.agreement);
  }

  // The light at nodes, which no view and no sample changes.
  [[gnu::noinline]] Lanes AtNode(const Lanes3& nodeGrid, LaneMask mask) const
  {
    const float longestMm = this->scene.shadows.nodeStepMm;
    if (this->IsSoft())
    {
      return this->TracedCone(nodeGrid, mask, longestMm);
    }
    const PacketRays rays = this->light.RaysFrom(nodeGrid);
    return this->AtEndOf(rays, mask, longestMm, KnownDepths(rays));
  }

  const PacketScene& scene;
  ShadowedLight light;
  Casters casters;
  LightCells cells;
};

[[gnu::noinline]] inline KnownDepth DepthOfCells(
  const TracedLight& light, const Lanes3& placeGrid, Lanes depth, LaneMask mask, Lanes taken)
{
  return light.DepthOf(placeGrid, depth, mask, taken);
}

/// The part of a light that reaches places in the grid of the rays.
struct LightFromRays
{
  const PacketScene& scene;
  TracedLight traced;

  Lanes At(const Lanes3& placeGrid, LaneMask mask) const
  {
    return this->traced.At(PlaceOfLight(this->scene, placeGrid), mask);
  }
};

/// Adds its samples to a sum without what shadows may take away, which it gathers. Its surfaces
/// know how much of the light from all around reaches them.
/// @tparam Voxels  AnyVoxels or AnyBoxes
template <class Voxels>
class DimmedMaterial : public LabelledMaterial
{
public:
  using SurfaceType = OpenSurface;

  DimmedMaterial(const PacketScene& scene, const PacketRays& rays)
    : LabelledMaterial(scene, rays)
    , voxels(SceneOfLight(scene))
    , lightCount(ShadowedLight::CountOf(scene))
    , casters(scene, rays)
    , sky(SceneOfLight(scene), SceneOfLight(scene))
    , gathered(this->lightCount, scene.rays.shadowStepMm)
  {
  }

  static constexpr bool IsPlain() { return false; }

  OpenSurface SurfaceAt(const Slope& slope, const Lanes3& placeGrid, LaneMask mask)
  {
    const Surface surface = this->SurfaceOf(slope.gradient);
    return this->scene.sky.strength > 0.0f ? OpenSurface{ surface,
      this->sky.At(
        PlaceOfLight(this->scene, this->OutsideOf(slope, placeGrid, this->voxels)), mask) }
                                           : OpenSurface{ surface, All(1.0f) };
  }

  void Add(PacketSum& sum, Lanes value, const OpenSurface& surface, const RayPart& part)
  {
    Optical look = this->LookOf(value, surface.gradient);
    look.extinction = Min(look.extinction, All(this->scene.shadows.mostExtinction));
    const LaneMask isSeen = LaneMask(look.extinction * part.lengthMm > 0.0f);
    if (!Any(isSeen))
    {
      return;
    }
    if (this->lightCount == 0)
    {
      const Lanes3 color = this->Shaded(look.color, surface, part.t);
      sum.Add({ surface.open * color, look.extinction }, part.lengthMm);
      return;
    }
    this->gathered.InPieces(look.extinction, sum.transmittance, part,
      [&](const RayPart& piece)
      {
        const Lanes3 color = this->GatheredFrom(sum, look, surface, piece, isSeen);
        sum.Add({ surface.open * color, look.extinction }, piece.lengthMm);
      });
  }

  [[gnu::noinline]] void AddGathered(PacketSum& sum)
  {
    const Lanes3 color = this->gathered.Flush(this->scene.shadows.tolerance,
      [&](int light, LitPlaces& places) { this->SetLight(light, places); });
    sum.color = sum.color + color;
  }

private:
  // Gathers what shadows may take away. Returns the colour without that.
  [[gnu::noinline]] Lanes3 GatheredFrom(PacketSum& sum, const Optical& look,
    const OpenSurface& surface, const RayPart& part, LaneMask isSeen)
  {
    if (this->gathered.IsFullAt(part.t, isSeen, look.extinction))
    {
      this->AddGathered(sum);
    }
    this->gathered.MoveTo(part.t, isSeen, look.extinction);
    const Lanes seen = surface.open * sum.transmittance *
      Absorption(Min(look.extinction * part.lengthMm, All(100.0f)));
    const RayPart inShadow{ part.t, 2.0f * this->gathered.HalfLengthMm(part.lengthMm) };
    return this->LitApart(this->ReflectorAt(surface, part.t), look.color, part.t, this->lightCount,
      [&](int light, const Lanes3& own)
      { this->gathered.Add(light, this->casters.Left(light, seen, inShadow, isSeen) * own); });
  }

  void SetLight(int light, LitPlaces& places) const
  {
    const LightFromRays found{ this->scene, { SceneOfLight(this->scene), light } };
    TracedPlaces<LightFromRays>(this->rays, found).Set(places);
  }

  Voxels voxels;  ///< the voxels of SceneOfLight
  int lightCount; ///< number of lights that cast shadows
  CastersOnRays casters;
  OpenSky sky;
  typename GatheringIn<Voxels>::Type gathered;
};

template <class Voxels>
OpenSurface SurfaceAt(
  DimmedMaterial<Voxels>& material, const Slope& slope, const Lanes3& placeGrid, LaneMask mask)
{
  return material.SurfaceAt(slope, placeGrid, mask);
}

template <class Voxels>
void AddLit(PacketSum& sum, DimmedMaterial<Voxels>& material, Lanes value,
  const OpenSurface& surface, const RayPart& part)
{
  material.Add(sum, value, surface, part);
}

template <class Voxels>
void AddOwed(PacketSum& sum, DimmedMaterial<Voxels>& material)
{
  material.AddGathered(sum);
}

/// Places of a packet, one for each of its pixels [grid space].
struct PacketPlaces
{
  Lanes3 placeGrid;
  LaneMask mask; ///< the pixels that have one
};

inline PacketPlaces PlacesOfPacket(const PacketScene& scene, int x, int y)
{
  const PacketReceivers& receivers = scene.receivers;
  float numbers[4][LaneCount];
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    const int column = x + lane % PacketWidth - receivers.pixels.left;
    const int row = y + lane / PacketWidth - receivers.pixels.bottom;
    const bool isInside =
      column >= 0 && column < receivers.pixels.width && row >= 0 && row < receivers.pixels.height;
    const std::ptrdiff_t pixel = std::ptrdiff_t(row) * receivers.pixels.width + column;
    for (int i = 0; i < 4; ++i)
    {
      numbers[i][lane] = isInside ? receivers.places[pixel][i] : 0.0f;
    }
  }
  return { { LanesAt(numbers[0]), LanesAt(numbers[1]), LanesAt(numbers[2]) },
    LaneMask(LanesAt(numbers[3]) > 0.0f) };
}

/// The parts of four lights that reach the places of a packet.
/// @param partOf  (index of a light, places) -> its part
template <class PartOf>
Lanes4 LightOnPlaces(const PacketScene& scene, const PacketPlaces& places, PartOf partOf)
{
  const auto lightOf = [&](int i)
  {
    const int light = scene.receivers.firstLight + i;
    return light < ShadowedLight::CountOf(scene) && Any(places.mask) ? partOf(light, places)
                                                                     : All(1.0f);
  };
  return { lightOf(0), lightOf(1), lightOf(2), lightOf(3) };
}

}

}

#endif
