#ifndef Varimarch_Core_Packets_Reach_ShadowedMaterial_h
#define Varimarch_Core_Packets_Reach_ShadowedMaterial_h

// The material of a volume whose lights cast shadows.

#include "Core/Packets/Flattened.h"
#include "Core/Packets/Reach/GatheredLight.h"
#include "Core/Packets/Reach/LightCells.h"
#include "Core/Packets/Reach/ShadowRays.h"

namespace varimarch
{

namespace
{

static_assert(MostShadows == MostShadowedLights);

/// The part of a light that reaches places in a volume.
template <class Voxels>
class TracedLight
{
public:
  /// @param light  its index
  TracedLight(const PacketScene& scene, const Voxels& voxels, int light)
    : scene(scene)
    , voxels(voxels)
    , light(scene, light)
    , cells(scene.shadows, light)
  {
  }

  Lanes At(const Lanes3& placeGrid, LaneMask mask) const
  {
    const PacketRays rays = this->light.RaysFrom(placeGrid);
    // Cells are read where a ray begins, and then ever farther apart.
    const Lanes cellMm = float(LightLattice::VoxelsPerNode) / Length(rays.directionGrid);
    Lanes next = {};
    const auto known = [&](Lanes t, Lanes& depth, LaneMask going)
    {
      const LaneMask asks = going & LaneMask(t >= next);
      if (!this->cells || !Any(asks))
      {
        return LaneMask{};
      }
      next = Select(asks, Max(2.0f * t, t + cellMm), next);
      return this->AddKnown(rays.At(t), depth, asks);
    };
    return this->AtEndOf(rays, mask, { this->scene.rays.shadowStepMm, this->MostDepth() }, known);
  }

private:
  // The depth beyond which all light that is left may be missing.
  float MostDepth() const
  {
    return this->scene.shadows.tolerance > 0.0f ? -__builtin_logf(this->scene.shadows.tolerance)
                                                : float(MostShadowDepth);
  }

  template <class Known>
  [[gnu::noinline]] FLATTENED Lanes AtEndOf(
    const PacketRays& rays, LaneMask mask, const ShadowMarch& march, Known known) const
  {
    return Exp(-ShadowDepth<Voxels>(this->scene, this->voxels, rays, march).Along(mask, known));
  }

  // Where the nodes of a cell agree, they tell the light at the end of a ray.
  LaneMask AddKnown(const Lanes3& placeGrid, Lanes& depth, LaneMask mask) const
  {
    mask &= this->cells.Contains(placeGrid);
    if (!Any(mask))
    {
      return mask;
    }
    const LightInCells found = this->cells.LightAt(placeGrid, mask,
      [&](const Lanes3& nodeGrid, LaneMask nodes) { return this->AtNode(nodeGrid, nodes); });
    const LaneMask agrees =
      mask & LaneMask(found.spread * Exp(-depth) <= this->scene.shadows.agreement);
    depth = depth - Select(agrees, Log(Max(found.between, 1e-6f)), Lanes{});
    return agrees;
  }

  // The light at nodes, which no view and no sample changes.
  [[gnu::noinline]] Lanes AtNode(const Lanes3& nodeGrid, LaneMask mask) const
  {
    return this->AtEndOf(this->light.RaysFrom(nodeGrid), mask,
      { this->scene.shadows.nodeStepMm, this->MostDepth() },
      [](Lanes, Lanes, LaneMask) { return LaneMask{}; });
  }

  const PacketScene& scene;
  const Voxels& voxels;
  ShadowedLight light;
  LightCells cells;
};

/// Adds its samples to a sum without what shadows may take away, which it gathers.
template <class Voxels>
class ShadowedMaterial : public PacketMaterial
{
public:
  ShadowedMaterial(const PacketScene& scene, const PacketRays& rays)
    : PacketMaterial(scene, rays)
    , voxels(scene.volume)
    , gathered(ShadowedLight::CountOf(scene), scene.rays.shadowStepMm)
  {
  }

  void Add(PacketSum& sum, Lanes value, const Surface& surface, const RayPart& part)
  {
    const Optical look = this->LookOf(value, surface.gradient);
    const LaneMask isSeen = LaneMask(look.extinction * part.lengthMm > 0.0f);
    if (!Any(isSeen))
    {
      return;
    }
    if (this->gathered.IsFullAt(part.t, isSeen))
    {
      this->AddGathered(sum);
    }
    this->gathered.MoveTo(part.t, isSeen);
    const Lanes seen =
      sum.transmittance * Absorption(Min(look.extinction * part.lengthMm, All(100.0f)));
    const Lanes3 color =
      PacketLights(this->scene, ReflectanceOf(this->scene), this->directionWorld)
        .LitApart(look.color, surface, this->WorldAt(part.t), ShadowedLight::CountOf(this->scene),
          [&](int light, const Lanes3& own) { this->gathered.Add(light, seen * own); });
    sum.Add({ color, look.extinction }, part.lengthMm);
  }

  [[gnu::noinline]] void AddGathered(PacketSum& sum)
  {
    const Lanes3 color = this->gathered.Flush(this->scene.shadows.tolerance,
      [&](int light, LitPlaces& places) { this->SetLight(light, places); });
    sum.color = sum.color + color;
  }

private:
  /// Places that wait for a packet of rays to a light, which may be of any rays of the eye.
  struct Waiting
  {
    float* light[LaneCount];
    int lane[LaneCount];
    float t[LaneCount] = {};
    int count = 0;
  };

  void SetLight(int light, LitPlaces& places) const
  {
    const TracedLight<Voxels> traced(this->scene, this->voxels, light);
    Waiting waiting;
    for (int place = 0; place < LitPlaces::MostPerRay; ++place)
    {
      for (int lane = 0; lane < LaneCount; ++lane)
      {
        if (place >= places.count[lane] || !places.isNeeded[place][lane])
        {
          continue;
        }
        const int next = waiting.count++;
        waiting.light[next] = &places.light[place][lane];
        waiting.lane[next] = lane;
        waiting.t[next] = places.t[place][lane];
        this->TraceFull(traced, waiting, LaneCount);
      }
    }
    this->TraceFull(traced, waiting, 1);
  }

  // Traces the light of places as soon as there are enough.
  void TraceFull(const TracedLight<Voxels>& traced, Waiting& waiting, int enough) const
  {
    if (waiting.count < enough)
    {
      return;
    }
    const LaneMask mask = IntLanesOf([&](int i) { return i < waiting.count ? -1 : 0; });
    const Numbers light(
      traced.At(this->PlacesOf(waiting.lane, waiting.count, LanesAt(waiting.t)), mask));
    for (int i = 0; i < waiting.count; ++i)
    {
      *waiting.light[i] = light.of[i];
    }
    waiting.count = 0;
  }

  Lanes3 PlacesOf(const int (&lanes)[LaneCount], int count, Lanes t) const
  {
    const auto gathered = [&](Lanes numbers)
    {
      const Numbers of(numbers);
      return LanesOf([&](int i) { return of.of[i < count ? lanes[i] : 0]; });
    };
    const Lanes3& origin = this->rays.originGrid;
    const Lanes3& direction = this->rays.directionGrid;
    return Lanes3(gathered(origin.x), gathered(origin.y), gathered(origin.z)) +
      t * Lanes3(gathered(direction.x), gathered(direction.y), gathered(direction.z));
  }

  Voxels voxels;
  GatheredLight gathered;
};

template <class Voxels>
void AddLit(PacketSum& sum, ShadowedMaterial<Voxels>& material, Lanes value, const Surface& surface,
  const RayPart& part)
{
  material.Add(sum, value, surface, part);
}

template <class Voxels>
void AddOwed(PacketSum& sum, ShadowedMaterial<Voxels>& material)
{
  material.AddGathered(sum);
}

}

}

#endif
