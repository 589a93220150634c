// Compiled as PacketTileAvx2.cxx is, of which this is a part that takes long.

#include "Core/Packets/PacketMixture.h"

#include "Core/Packets/PacketConstituent.h"
#include "Core/Packets/PacketMarchers.h"

namespace varimarch
{

namespace
{

/// Steps through all constituents together, from face to face of their boxes, and leaves what none
/// of them shows.
/// @param first  whose rays they are
/// @param last   the constituent that knows all others
PacketSum MarchTogether(const PacketScene& first, const PacketRays& rays, const PacketWalk& walk,
  Constituent& last, const PacketSum& before)
{
  constexpr float Part = 1.0f / PartsPerSegment;
  const float plainMm = PartsPerSegment * first.rays.stepMm;
  PacketSum sum = before;
  Lanes t = rays.enter;
  LaneMask going = GoOn(first, rays, t, sum);
  for (int index = 0; index < first.rays.mostSegments && Any(going); ++index)
  {
    const SegmentLanes visible = last.NextVisible(t, going);
    const Lanes enter = Min(visible.enter, rays.exit);
    going &= LaneMask(enter < rays.exit);
    if (!Any(going))
    {
      break; // all that is left is invisible
    }
    const Lanes plain = enter + walk.StepMm(AllInt(index), plainMm, sum.opticalDepth);
    t = Min(Min(Max(plain, visible.exit), last.NextFace(enter, going)), rays.exit);
    const Lanes partMm = Select(going, (t - enter) * Part, Lanes{});
    MixedSegment mixture;
    last.AddTo(mixture, { enter + 0.5f * partMm, partMm }, going);
    for (const Optical& part : mixture.parts)
    {
      sum.Add({ (1.0f / Max(part.extinction, All(1e-30f))) * part.color, part.extinction }, partMm);
    }
    going &= GoOn(first, rays, t, sum);
  }
  return sum;
}

// What a march begins with.
struct MixturePlace
{
  const PacketScene& first;
  const PacketRays& rays;
  const PacketWalk& walk;
  const PacketSum& before;
  int x;
  int y;
};

// One constituent behind the other, the first at last: they know each other, and live on the stack.
PacketSum MarchBehind(const MixturePlace& place, int next, Constituent* known)
{
  const PacketConstituent& all = place.first.constituent;
  const PacketScene& scene = next < all.otherCount ? all.others[next] : place.first;
  Constituent constituent(scene, place.rays, place.x, place.y, known);
  return next < all.otherCount
    ? MarchBehind(place, next + 1, &constituent)
    : MarchTogether(place.first, place.rays, place.walk, constituent, place.before);
}

}

PacketSum MarchMixture(const PacketScene& first, const PacketRays& rays, const PacketWalk& walk,
  const PacketSum& before, int x, int y)
{
  return MarchBehind({ first, rays, walk, before, x, y }, 0, nullptr);
}

}
