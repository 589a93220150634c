#ifndef Varimarch_Core_Packets_March_Several_h
#define Varimarch_Core_Packets_March_Several_h

// Several components of a volume, and volumes that overlap, in one march by midpoints.
// Twin of March/Several.glsl.

#include "Core/Packets/Loop/Segments.h"
#include "Core/Packets/PacketTileMarch.h"
#include "Core/Packets/Volumes/Next.h"

namespace varimarch
{

namespace
{

/// Marches all constituents together, from face to face of their boxes, and skips what none of
/// them shows.
/// @param piece  in the grid of the first constituent
/// @param last   the constituent that knows all others
/// @tparam Light  MixedLight or UnmixedLight
template <class Light>
PacketSum MarchTogether(const PacketPiece& piece, Constituent& last, Light light)
{
  const PacketScene& first = piece.scene;
  const PacketRays& rays = piece.rays;
  constexpr float Part = 1.0f / PartsPerSegment;
  const float plainMm = PartsPerSegment * first.rays.stepMm;
  PacketSum sum = piece.before;
  Lanes t = rays.enter;
  LaneMask going = GoOn(first, rays, t, sum);
  for (int index = 0; index < first.rays.mostSegments && Any(going); ++index)
  {
    const SegmentLanes visible = last.NextVisible(t, going);
    const Lanes enter = Min(visible.enter, rays.exit);
    going &= LaneMask(enter < rays.exit);
    if (!Any(going))
    {
      break; // the rest is invisible
    }
    const Lanes plain = enter + piece.walk.StepMm(AllInt(index), plainMm, sum.opticalDepth);
    t = Min(Min(Max(plain, visible.exit), last.NextFace(enter, going)), rays.exit);
    const Lanes partMm = Select(going, (t - enter) * Part, Lanes{});
    const PartLanes parts{ enter + 0.5f * partMm, partMm };
    MixedSegment mixture = NextSegment(light);
    last.AddTo(mixture, parts, going);
    for (int i = 0; i < PartsPerSegment; ++i)
    {
      const Optical& part = mixture.parts[i];
      const Lanes3 color = (1.0f / Max(part.extinction, All(1e-30f))) * part.color;
      light.InPieces(part.extinction, sum.transmittance, { parts.MiddleOf(i), partMm },
        [&](const RayPart& piece)
        {
          light.Gather(sum, i, piece, part.extinction);
          sum.Add({ color, part.extinction }, piece.lengthMm);
        });
    }
    going &= GoOn(first, rays, t, sum);
  }
  light.AddGathered(sum);
  return sum;
}

/// Makes the constituents from the first to the last on the stack, each of which knows the one
/// before it.
inline PacketSum MarchBehind(const PacketPiece& piece, int next, Constituent* known)
{
  const PacketConstituent& all = piece.scene.constituent;
  const PacketScene& scene = next < all.otherCount ? all.others[next] : piece.scene;
  Constituent constituent(scene, piece, known);
  if (next < all.otherCount)
  {
    return MarchBehind(piece, next + 1, &constituent);
  }
  return piece.scene.light.castsShadows
    ? MarchTogether(piece, constituent, MixedLight(piece.scene, piece.rays))
    : MarchTogether(piece, constituent, UnmixedLight());
}

}

}

#endif
