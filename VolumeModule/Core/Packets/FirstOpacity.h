#ifndef Varimarch_Core_Packets_FirstOpacity_h
#define Varimarch_Core_Packets_FirstOpacity_h

// The places where rays first have an opacity.
// Twin of FirstOpacity.glsl.

#include "Core/Packets/Blend/Composite.h"
#include "Core/Packets/Classify/OpticalTable.h"
#include "Core/Packets/PacketRays.h"
#include "Core/Packets/PacketScene.h"
#include "Core/Packets/ShaderMath.h"
#include "Core/Packets/Step/OpticalField.h"

namespace varimarch
{

namespace
{

/// A march in pieces. The piece in which a ray reaches the opacity is halved until the opacity can
/// be taken as linear.
template <class March>
class OpacityLocation
{
public:
  /// @param march  (piece of the rays, sum before it) -> the sum behind it
  OpacityLocation(const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk,
    float opacity, March march)
    : scene(scene)
    , rays(rays)
    , walk(walk)
    , opacity(opacity)
    , march(march)
    , t(rays.enter)
    , end(rays.exit)
  {
  }

  /// @return t [mm]; Never for rays that do not reach the opacity
  Lanes Find()
  {
    const Lanes shortestMm = ShortestPiece / Length(this->rays.directionGrid);
    LaneMask going = LaneMask(this->t < this->end);
    for (int index = 0; index < this->scene.rays.mostSegments && Any(going); ++index)
    {
      this->MarchPiece(index, going);
      const Lanes shortest = Select(LaneMask(this->endOpacity > 0.0f), shortestMm, Lanes{});
      going &= LaneMask(this->end - this->t > shortest);
    }
    const Lanes begun = 1.0f - this->sum.transmittance;
    const Lanes along = (this->opacity - begun) / Max(this->endOpacity - begun, All(1e-30f));
    return Select(LaneMask(this->endOpacity > 0.0f),
      Mix(this->t, this->end, Clamp(along, Lanes{}, All(1.0f))), All(Never));
  }

private:
  static constexpr float StepsPerPiece = 8.0f;
  static constexpr float ShortestPiece = 0.25f;

  void MarchPiece(int index, LaneMask mask)
  {
    const LaneMask isHalf = LaneMask(this->endOpacity > 0.0f);
    const SegmentLanes segment = this->walk.NextSegment(this->t, AllInt(index),
      StepsPerPiece * this->scene.rays.stepMm, this->sum.opticalDepth, mask & ~isHalf);
    const Lanes begin = Select(isHalf, this->t, segment.enter);
    PacketRays piece = this->rays;
    piece.enter = this->t;
    piece.exit = Select(isHalf, 0.5f * (this->t + this->end), Min(segment.exit, this->rays.exit));
    piece.exit = Select(mask, piece.exit, this->t);
    const PacketSum next = this->march(piece, this->sum);
    const Lanes reached = 1.0f - next.transmittance;
    const LaneMask isBefore = LaneMask(reached < this->opacity) | LaneMask(begin >= piece.exit);
    const LaneMask isFound = mask & ~isBefore;
    this->sum = Select(mask & isBefore, next, this->sum);
    this->end = Select(isFound, piece.exit, this->end);
    this->endOpacity = Select(isFound, reached, this->endOpacity);
    this->t = Select(mask, Select(isFound, begin, piece.exit), this->t);
  }

  const PacketScene& scene;
  const PacketRays& rays;
  const PacketWalk& walk;
  float opacity;
  March march;
  PacketSum sum;
  Lanes t;
  Lanes end;
  Lanes endOpacity = {}; ///< the opacity at `end`; 0 until a piece with enough is found
};

}

}

#endif
