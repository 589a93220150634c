#ifndef Varimarch_Core_Packets_PacketPieces_h
#define Varimarch_Core_Packets_PacketPieces_h

// Rays with pieces that are left out, or that are drawn by rules of their own: Shaders/Crop,
// Shaders/Mask and Shaders/Gaps.

#include "Core/Fields/GapField.h"
#include "Core/Packets/Lanes.h"
#include "Core/Packets/PacketLattice.h"
#include "Core/Packets/PacketMarchers.h"
#include "Core/Packets/PacketOptics.h"
#include "Core/Packets/PacketRays.h"
#include "Core/Packets/PacketScene.h"

namespace varimarch
{

namespace
{

/// Shaders/Crop/Regions.glsl: six planes cut rays into pieces, each of which lies in one region.
class CroppedPieces
{
public:
  CroppedPieces(const PacketScene& scene, const PacketRays& rays)
    : parameters(scene.rays)
    , rays(rays)
    , t(rays.enter)
  {
    for (int i = 0; i < 6; ++i)
    {
      const glm::vec4& plane = this->parameters.croppingPlanes[i];
      this->crossings[i] =
        -BeyondPlane(plane, rays.originGrid) / ApproachToPlane(plane, rays.directionGrid);
    }
  }

  /// The next part of the rays of a mask that is drawn: all pieces that follow each other. It has
  /// no length for a ray without one, and for other rays.
  PacketRays Next(LaneMask mask)
  {
    PacketRays drawn = this->rays;
    drawn.enter = this->t;
    LaneMask isFound = {};
    while (Any(mask))
    {
      const Lanes end = this->NextCrossing();
      const LaneMask isDrawn = this->IsDrawn(0.5f * (this->t + end));
      mask &= isDrawn | ~isFound;
      this->t = Select(mask, end, this->t);
      isFound |= mask & isDrawn;
      drawn.enter = Select(isFound, drawn.enter, this->t);
      mask &= LaneMask(this->t < this->rays.exit);
    }
    drawn.exit = this->t;
    return drawn;
  }

private:
  Lanes NextCrossing() const
  {
    Lanes next = this->rays.exit;
    for (const Lanes& crossing : this->crossings)
    {
      next = Select(LaneMask(crossing > this->t), Min(crossing, next), next);
    }
    return next;
  }

  LaneMask IsDrawn(Lanes place) const
  {
    const Lanes3 position = this->rays.At(place);
    IntLanes region = {};
    for (int axis = 2; axis >= 0; --axis)
    {
      const shader::vec4* const planes = this->parameters.croppingPlanes + 2 * axis;
      const LaneMask isBeyondLower = LaneMask(BeyondPlane(planes[0], position) >= 0.0f);
      const LaneMask isBeyondUpper = LaneMask(BeyondPlane(planes[1], position) >= 0.0f);
      region = 3 * region - isBeyondLower - isBeyondUpper; // a mask is -1
    }
    return LaneMask((AllInt(this->parameters.croppingRegions) >> region & 1) != 0);
  }

  const RayParameters& parameters;
  const PacketRays& rays;
  Lanes t; ///< the end of the last piece
  Lanes crossings[6];
};

/// Shaders/Mask/Voxels.glsl: the cubes around a mask's voxels, joined where their content is the
/// same.
class MaskedPieces
{
public:
  MaskedPieces(const PacketScene& scene, const PacketRays& rays)
    : mask(scene.mask)
    , rays(rays)
    , lattice(rays, 1.0f, -0.5f, scene.volume.voxelCount)
    , place(lattice.At(rays.enter))
  {
  }

  /// See CroppedPieces.
  PacketRays Next(LaneMask searching)
  {
    PacketRays drawn = this->rays;
    drawn.enter = this->place.t;
    LaneMask isFound = {};
    while (Any(searching))
    {
      const IntNumbers index = this->lattice.IndexOf(this->place.cell);
      const IntLanes content = this->TexelsAt(index, 0);
      const LaneMask isDrawn = this->mask.isBinary ? content != 0 : AllInt(-1);
      searching &= ~isFound | (content == drawn.region);
      drawn.region = Select(searching & ~isFound, content, drawn.region);
      const Lanes radius = FloatOf(this->TexelsAt(index, 1) - 1);
      this->place = Select(searching, this->lattice.BehindBlock(this->place, radius), this->place);
      isFound |= searching & isDrawn;
      drawn.enter = Select(isFound, drawn.enter, this->place.t);
      searching &= LaneMask(this->place.t < this->rays.exit);
    }
    drawn.enter = Min(drawn.enter, this->rays.exit);
    drawn.exit = Min(this->place.t, this->rays.exit);
    return drawn;
  }

private:
  IntLanes TexelsAt(const IntNumbers& index, int which) const
  {
    return IntLanesOf([&](int lane)
      { return std::int32_t(this->mask.texels[2 * std::ptrdiff_t(index.of[lane]) + which]); });
  }

  const PacketMask& mask;
  const PacketRays& rays;
  PacketLattice lattice;
  LatticePlace place; ///< the end of the last piece
};

/// @tparam Pieces  CroppedPieces or MaskedPieces
/// @param before  the sum in front of the rays
/// @param march   (piece of the rays, sum before it) -> the sum behind it
template <class Pieces, class March>
PacketSum MarchPieces(
  const PacketScene& scene, const PacketRays& rays, const PacketSum& before, March march)
{
  Pieces pieces(scene, rays);
  PacketSum sum = before;
  Lanes t = rays.enter;
  for (LaneMask going = GoOn(scene, rays, t, sum); Any(going); going &= GoOn(scene, rays, t, sum))
  {
    const PacketRays piece = pieces.Next(going);
    sum = march(piece, sum);
    t = piece.exit;
  }
  return sum;
}

/// Shaders/Gaps/Cells.glsl: marches between gaps, and fills places without a value.
/// @param march  (piece of the rays, sum before it) -> the sum behind it
template <class March>
PacketSum MarchAroundGaps(
  const PacketScene& scene, const PacketRays& rays, const PacketSum& before, March march)
{
  const PacketGaps& gaps = scene.gaps;
  const PacketLattice lattice(rays, 1.0f, -scene.parameters.gapShift, gaps.count);
  const glm::vec4& fill = scene.parameters.gapOptical;
  const Optical filled{ { All(fill.x), All(fill.y), All(fill.z) }, All(fill.w) };
  const auto texelsAt = [&](const IntNumbers& index)
  { return IntLanesOf([&](int lane) { return std::int32_t(gaps.texels[index.of[lane]]); }); };
  PacketSum sum = before;
  LatticePlace place = lattice.At(rays.enter);
  for (LaneMask going = GoOn(scene, rays, place.t, sum); Any(going);
       going &= GoOn(scene, rays, place.t, sum))
  {
    // Blocks without a gap are joined into one piece.
    PacketRays part = rays;
    part.enter = part.exit = place.t;
    LaneMask hasNoValue = {};
    for (LaneMask searching = going; Any(searching); searching &= LaneMask(place.t < rays.exit))
    {
      const IntLanes texel = texelsAt(lattice.IndexOf(place.cell));
      const LaneMask isGap = (texel == GapField::NoValue) | (texel == GapField::LeftOut);
      const Lanes radius = Select(isGap, Lanes{}, FloatOf(texel - 1));
      place = Select(searching, lattice.BehindBlock(place, radius), place);
      part.exit = Select(searching & ~isGap, Min(place.t, rays.exit), part.exit);
      hasNoValue |= searching & (texel == GapField::NoValue);
      searching &= ~isGap;
    }
    sum = march(part, sum);
    const Lanes gapMm = Max(Min(place.t, rays.exit) - part.exit, Lanes{});
    sum.Add(filled, Select(hasNoValue, gapMm, Lanes{}));
  }
  return sum;
}

}

}

#endif
