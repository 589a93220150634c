#ifndef Varimarch_Core_Packets_Volumes_MixedLight_h
#define Varimarch_Core_Packets_Volumes_MixedLight_h

// Light in a mixture. The optical depths of its constituents add up along a ray to a light, so that
// the light that reaches a place is the product of what each of them lets through.
// Twin of Around/Volumes.glsl.

#include "Core/Packets/Reach/DimmedMaterial.h"

namespace varimarch
{

namespace
{

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

}

}

#endif
