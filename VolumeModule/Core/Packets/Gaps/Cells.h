#ifndef Varimarch_Core_Packets_Gaps_Cells_h
#define Varimarch_Core_Packets_Gaps_Cells_h

// Twin of Gaps/Cells.glsl and Fill/Color.glsl.

#include "Core/Fields/GapField.h"
#include "Core/Packets/Loop/Segments.h"
#include "Core/Packets/PacketLattice.h"

namespace varimarch
{

namespace
{

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

}

}

#endif
