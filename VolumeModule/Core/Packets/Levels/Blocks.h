#ifndef Varimarch_Core_Packets_Levels_Blocks_h
#define Varimarch_Core_Packets_Levels_Blocks_h

// Rays through blocks some of which are drawn by their voxels, and others by coarser levels.

#include "Core/Packets/PacketLattice.h"
#include "Core/Packets/PacketPieces.h"

namespace varimarch
{

namespace
{

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
