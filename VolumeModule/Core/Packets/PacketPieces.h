#ifndef Varimarch_Core_Packets_PacketPieces_h
#define Varimarch_Core_Packets_PacketPieces_h

// Rays whose pieces are marched one by one.

#include "Core/Packets/Loop/Segments.h"
#include "Core/Packets/PacketRays.h"

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

}

}

#endif
