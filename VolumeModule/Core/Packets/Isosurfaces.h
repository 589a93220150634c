#ifndef Varimarch_Core_Packets_Isosurfaces_h
#define Varimarch_Core_Packets_Isosurfaces_h

// Isosurfaces of interpolated voxels, none of which is missed or crossed twice.
// Twin of March/Isosurfaces.glsl and SurfaceTable.glsl.

#include "Core/Packets/Looks.h"
#include "Core/Packets/Materials.h"
#include "Core/Packets/PacketScene.h"
#include "Core/Packets/Rays.h"
#include "Core/Packets/ShaderMath.h"
#include "Core/Packets/Voxels.h"
#include "Core/Packets/Walk.h"

namespace varimarch
{

namespace
{

template <class Voxels>
class IsosurfaceMarch
{
public:
  IsosurfaceMarch(const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk,
    const PacketSum& before)
    : scene(scene)
    , surfaceCount(scene.parameters.isosurfaceCount)
    , rays(rays)
    , walk(walk)
    , material(scene, rays)
    , voxels(scene)
    // The space before the first voxel and behind the last one is divided into cells too.
    , cells(rays, 1.0f, -1.0f, scene.volume.voxelCount + 1)
    , place(cells.At(rays.enter))
    , sum(before)
  {
  }

  PacketSum March()
  {
    const Lanes segmentMm = CellsPerSegment / Length(this->rays.directionGrid);
    LaneMask going = this->GoingOf(this->rays.exit);
    for (int index = 0; index < this->scene.rays.mostSegments && Any(going); ++index)
    {
      const SegmentLanes segment = this->walk.NextOfBricks(this->place.t, segmentMm, going);
      const LaneMask jumps = going & LaneMask(segment.enter > this->place.t);
      this->place = Select(jumps, this->cells.At(segment.enter), this->place);
      this->known &= ~jumps;
      going &= this->GoingOf(this->rays.exit);
      this->MarchCells(Min(segment.exit, this->rays.exit), going);
      going &= this->GoingOf(this->rays.exit);
    }
    return this->sum;
  }

private:
  static constexpr float CellsPerSegment = 4.0f;

  LaneMask GoingOf(Lanes end) const
  {
    return LaneMask(this->place.t < end) &
      LaneMask(this->sum.opticalDepth <= this->scene.steps.mostOpticalDepth);
  }

  // Marches the rays of a mask to the end of the cell that contains `end`.
  void MarchCells(Lanes end, LaneMask mask)
  {
    while (Any(mask))
    {
      const LatticePlace behind = this->cells.Behind(this->place);
      const Lanes exit = Min(behind.t, this->rays.exit);
      const Lanes4 cubic = this->NextCubic(exit, mask);
      const LaneMask holds = mask & this->MayHoldSurface(cubic);
      if (Any(holds))
      {
        this->AddSurfaces(cubic, exit, holds);
      }
      this->place = Select(mask, behind, this->place);
      mask &= this->GoingOf(end);
    }
  }

  // Begins with the value at the end of the last cell: computed anew it would be rounded
  // differently, and a surface between both values would be missed.
  Lanes4 NextCubic(Lanes exit, LaneMask mask)
  {
    Lanes4 cubic = CubicBetween(this->voxels.CornersOf(this->place.cell - 1.0f),
      this->rays.At(this->place.t), this->rays.At(exit));
    cubic.x = Select(this->known, this->endValue, cubic.x);
    this->endValue = Select(mask, cubic.w, this->endValue);
    this->known |= mask;
    return cubic;
  }

  LaneMask MayHoldSurface(const Lanes4& cubic) const
  {
    const Lanes lower = Min(Min(cubic.x, cubic.y), Min(cubic.z, cubic.w));
    const Lanes upper = Max(Max(cubic.x, cubic.y), Max(cubic.z, cubic.w));
    LaneMask holds = {};
    for (int surface = 0; surface < this->surfaceCount; ++surface)
    {
      const float isovalue = this->scene.textures.isosurfaces[2 * surface + 1].x;
      holds |= LaneMask(lower < isovalue) & LaneMask(upper >= isovalue);
    }
    return holds;
  }

  void AddSurfaces(const Lanes4& cubic, Lanes exit, LaneMask mask)
  {
    const Lanes2 extremes = CubicExtremes(cubic);
    this->AddMonotone(cubic, { Lanes{}, extremes.x }, exit, mask);
    this->AddMonotone(cubic, { extremes.x, extremes.y }, exit, mask);
    this->AddMonotone(cubic, { extremes.y, All(1.0f) }, exit, mask);
  }

  void AddMonotone(const Lanes4& cubic, MonotonePiece piece, Lanes exit, LaneMask mask)
  {
    const Lanes begin = CubicValue(cubic, piece.begin);
    const Lanes end = CubicValue(cubic, piece.end);
    const LaneMask rises = LaneMask(end > begin);
    for (int i = 0; i < this->surfaceCount; ++i)
    {
      const IntNumbers surface(Select(rises, AllInt(i), AllInt(this->surfaceCount - 1 - i)));
      const Lanes isovalue = this->EntriesOf(surface, 1).color.x;
      const LaneMask isPassed =
        mask & LaneMask(Min(begin, end) < isovalue) & LaneMask(Max(begin, end) >= isovalue);
      if (Any(isPassed))
      {
        const Lanes u = CrossingOf(cubic, isovalue, piece, isPassed);
        this->AddSurface(surface, Mix(this->place.t, exit, u), isPassed);
      }
    }
  }

  void AddSurface(const IntNumbers& surface, Lanes t, LaneMask mask)
  {
    Optical optical = this->EntriesOf(surface, 0);
    const Lanes3 gradient = this->voxels.SlopeAt(this->rays.At(t), mask).gradient;
    optical.color = this->material.Shaded(optical.color, this->material.SurfaceOf(gradient), t);
    this->sum.Add(optical, Select(mask, All(1.0f), Lanes{}));
  }

  Optical EntriesOf(const IntNumbers& surface, int which) const
  {
    Four entries[LaneCount];
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      entries[lane] = FourAt(&this->scene.textures.isosurfaces[2 * surface.of[lane] + which].x);
    }
    return OpticalOf(entries);
  }

  const PacketScene& scene;
  int surfaceCount;
  const PacketRays& rays;
  const PacketWalk& walk;
  PacketMaterial material;
  Voxels voxels;
  PacketLattice cells;
  LatticePlace place;
  LaneMask known = {}; ///< the rays whose value at the place is known
  Lanes endValue = {};
  PacketSum sum;
};

}

}

#endif
