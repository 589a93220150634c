#ifndef Varimarch_Core_Packets_PacketPieces_h
#define Varimarch_Core_Packets_PacketPieces_h

// Rays whose pieces are marched one by one.

#include "Core/Packets/Crop/Regions.h"
#include "Core/Packets/Loop/Segments.h"
#include "Core/Packets/Mask/Voxels.h"

namespace varimarch
{

namespace
{

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

}

}

#endif
