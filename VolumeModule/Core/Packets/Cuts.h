#ifndef Varimarch_Core_Packets_Cuts_h
#define Varimarch_Core_Packets_Cuts_h

// The pieces into which cropping, a mask, gaps and blocks of levels divide rays.
// Twin of Crop/Regions.glsl, Mask/Voxels.glsl, Gaps/Cells.glsl and Fill/Color.glsl.

#include "Core/Fields/GapField.h"
#include "Core/Packets/Rays.h"
#include "Core/Packets/Walk.h"

namespace varimarch
{

namespace
{

/// Marches pieces of rays one after another.
/// @tparam Pieces  made from a scene and rays. Its Next(mask) returns the next part of the rays of
/// a
///                 mask that is drawn as a whole. It has no length for a ray without one, and for
///                 other rays.
/// @param before   the sum in front of the rays
/// @param march    (piece of the rays, sum before it) -> the sum behind it
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

/// Six planes cut rays into pieces, each of which lies in one region.
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

  /// See MarchPieces: all pieces that are drawn and follow each other.
  PacketRays Next(LaneMask mask)
  {
    PacketRays drawn = this->rays;
    drawn.enter = this->t;
    LaneMask isFound = {};
    while (Any(mask))
    {
      const Lanes end = this->NextCrossing(this->t);
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

  /// The rays whose region at a place is drawn.
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

  /// The next place at which rays meet a plane, or their exit.
  Lanes NextCrossing(Lanes from) const
  {
    Lanes next = this->rays.exit;
    for (const Lanes& crossing : this->crossings)
    {
      next = Select(LaneMask(crossing > from), Min(crossing, next), next);
    }
    return next;
  }

private:
  const RayParameters& parameters;
  const PacketRays& rays;
  Lanes t; ///< the end of the last piece
  Lanes crossings[6];
};

/// The cubes around a mask's voxels, joined where their content is the
/// same.
class MaskedPieces
{
public:
  MaskedPieces(const PacketScene& scene, const PacketRays& rays)
    : texels(scene.textures.maskTexture.Texels<std::uint16_t>())
    , leastContent(scene.parameters.leastContent)
    , rays(rays)
    , lattice(rays, 1.0f, -0.5f, scene.volume.voxelCount)
    , place(lattice.At(rays.enter))
  {
  }

  /// See MarchPieces.
  PacketRays Next(LaneMask searching)
  {
    PacketRays drawn = this->rays;
    drawn.enter = this->place.t;
    LaneMask isFound = {};
    while (Any(searching))
    {
      const IntNumbers index = this->lattice.IndexOf(this->place.cell);
      const IntLanes content = this->TexelsAt(index, 0);
      const LaneMask isDrawn = LaneMask(FloatOf(content) > this->leastContent);
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
      { return std::int32_t(this->texels[2 * std::ptrdiff_t(index.of[lane]) + which]); });
  }

  const std::uint16_t* texels;
  float leastContent;
  const PacketRays& rays;
  PacketLattice lattice;
  LatticePlace place; ///< the end of the last piece
};

/// The content of a mask along rays that are followed forwards.
class MaskWalk
{
public:
  MaskWalk(const PacketScene& scene, const PacketRays& rays)
    : texels(scene.textures.maskTexture.Texels<std::uint16_t>())
    , lattice(rays, 1.0f, -0.5f, scene.volume.voxelCount)
    , next(lattice.At(rays.enter))
  {
  }

  /// Goes on to places of the rays of a mask. Returns where the content may change next.
  Lanes GoTo(Lanes t, LaneMask mask)
  {
    for (LaneMask behind = mask & LaneMask(t >= this->next.t); Any(behind);
         behind &= LaneMask(t >= this->next.t))
    {
      const IntNumbers index = this->lattice.IndexOf(this->next.cell);
      const auto texelsAt = [&](int which)
      {
        return IntLanesOf([&](int lane)
          { return std::int32_t(this->texels[2 * std::ptrdiff_t(index.of[lane]) + which]); });
      };
      this->content = Select(behind, texelsAt(0), this->content);
      const Lanes radius = Max(FloatOf(texelsAt(1) - 1), Lanes{});
      this->next = Select(behind, this->lattice.BehindBlock(this->next, radius), this->next);
    }
    return this->next.t;
  }

  /// The content where the rays are.
  IntLanes Content() const { return this->content; }

private:
  const std::uint16_t* texels;
  PacketLattice lattice;
  LatticePlace next; ///< where the rays leave the block whose content is known
  IntLanes content = {};
};

/// Marches between gaps, and fills places without a value.
/// @param march  (piece of the rays, sum before it) -> the sum behind it
template <class March>
PacketSum MarchAroundGaps(
  const PacketScene& scene, const PacketRays& rays, const PacketSum& before, March march)
{
  const std::uint8_t* const texels = scene.textures.gapTexture.Texels<std::uint8_t>();
  const PacketLattice lattice(
    rays, 1.0f, -scene.parameters.gapShift, glm::ivec3(scene.parameters.gapCellCount));
  const glm::vec4& fill = scene.parameters.gapOptical;
  const Optical filled{ { All(fill.x), All(fill.y), All(fill.z) }, All(fill.w) };
  const auto texelsAt = [&](const IntNumbers& index)
  { return IntLanesOf([&](int lane) { return std::int32_t(texels[index.of[lane]]); }); };
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

/// Blocks of one level, joined.
class LevelPieces
{
public:
  LevelPieces(const PacketScene& scene, const PacketRays& rays)
    : ofBlocks(scene.levels.ofBlocks)
    , rays(rays)
    , lattice(rays, scene.levels.blockSideGrid, 0.0f, scene.levels.blockCount)
    , place(lattice.At(rays.enter))
  {
  }

  /// See MarchPieces. The region of a piece is the number of its BlockLevel.
  PacketRays Next(LaneMask searching)
  {
    PacketRays piece = this->rays;
    piece.enter = this->place.t;
    piece.region = this->LevelsAt(this->place);
    while (Any(searching))
    {
      this->place = Select(searching, this->lattice.Behind(this->place), this->place);
      searching &=
        LaneMask(this->place.t < this->rays.exit) & (this->LevelsAt(this->place) == piece.region);
    }
    piece.enter = Min(piece.enter, this->rays.exit);
    piece.exit = Min(this->place.t, this->rays.exit);
    return piece;
  }

private:
  IntLanes LevelsAt(const LatticePlace& at) const
  {
    const IntNumbers index = this->lattice.IndexOf(at.cell);
    return IntLanesOf([&](int lane) { return std::int32_t(this->ofBlocks[index.of[lane]]); });
  }

  const BlockLevel* ofBlocks;
  const PacketRays& rays;
  PacketLattice lattice;
  LatticePlace place; ///< the end of the last piece
};

/// The rays of a level, and no length of others.
inline PacketRays OfLevel(const PacketRays& piece, int level)
{
  PacketRays own = piece;
  own.exit = Select(piece.region == std::int32_t(level), piece.exit, piece.enter);
  own.region = IntLanes{};
  return own;
}

/// Marches the blocks of each level by a scene of its own.
/// @param march  (scene, piece of the rays in its grid, sum before it) -> the sum behind it
template <class March>
PacketSum MarchByLevels(
  const PacketScene& scene, const PacketRays& rays, const PacketSum& before, March march)
{
  return MarchPieces<LevelPieces>(scene, rays, before,
    [&](const PacketRays& piece, PacketSum sum)
    {
      for (int level = 0; level < scene.levels.count; ++level)
      {
        const PacketScene& own = *scene.levels.scenes[level];
        const PacketRays ofLevel = OfLevel(piece, level);
        if (Any(LaneMask(ofLevel.enter < ofLevel.exit)))
        {
          sum = march(own, InGridOf(own.parameters, ofLevel), sum);
        }
      }
      return sum;
    });
}

}

}

#endif
