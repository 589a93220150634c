#ifndef Varimarch_Core_Packets_Reach_AbsorbingPieces_h
#define Varimarch_Core_Packets_Reach_AbsorbingPieces_h

// Pieces of rays in homogeneous matter that absorb the same: light changes along dense matter, and
// counts where it is seen.

#include "Core/Packets/Material/OneComponent.h"
#include "Core/Packets/Reach/LitPlaces.h"

#include <algorithm>

namespace varimarch
{

namespace
{

/// Divides parts of rays, each in homogeneous matter, into pieces that absorb the same.
class AbsorbingPieces
{
public:
  /// @param transmittance  in front of the parts
  /// @param times          how many times as many pieces as light asks for
  AbsorbingPieces(Lanes extinction, Lanes transmittance, const RayPart& part, Lanes times)
    : extinction(extinction)
    , enter(part.t - 0.5f * part.lengthMm)
    , lengthMm(part.lengthMm)
    , absorption(Absorption(Min(extinction * part.lengthMm, All(100.0f))))
  {
    const Numbers wanted(float(PiecesOfWhole) * transmittance * this->absorption * times);
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      const float most = std::min(wanted.of[lane], float(LitPlaces::MostPerRay));
      this->count = std::max(this->count, int(__builtin_ceilf(most)));
    }
  }

  int Count() const { return this->count; }

  /// A piece, in whose middle as much light is absorbed in front as behind.
  RayPart At(int piece) const
  {
    const float part = 1.0f / float(this->count);
    const Lanes begin = this->Along(float(piece) * part);
    const Lanes end =
      piece + 1 == this->count ? this->lengthMm : this->Along(float(piece + 1) * part);
    return { this->enter + this->Along((float(piece) + 0.5f) * part), Max(end - begin, Lanes{}) };
  }

private:
  static constexpr int PiecesOfWhole = 4;

  // The length in front of which a part of all that is absorbed is absorbed.
  Lanes Along(float part) const
  {
    constexpr float Thin = 0.01f; // light is absorbed evenly
    const LaneMask isThin = LaneMask(this->absorption < Thin);
    const Lanes depth = -Log(1.0f - part * this->absorption);
    return Select(isThin, part * this->lengthMm,
      Min(depth / Select(isThin, All(1.0f), this->extinction), this->lengthMm));
  }

  Lanes extinction;
  Lanes enter;
  Lanes lengthMm;
  Lanes absorption;
  int count = 1;
};

/// Calls a function with a part of rays, or with its pieces where it is so dense that its middle
/// says nothing about its light.
/// @param transmittance  in front of the part
/// @param add            (part or piece)
template <class Add>
void AddInPieces(Lanes extinction, const Lanes& transmittance, const RayPart& part, Add add)
{
  constexpr float DepthOfDense = 0.5f;
  const LaneMask isDense = LaneMask(extinction * part.lengthMm > DepthOfDense);
  const bool isInPieces = Any(isDense);
  const AbsorbingPieces pieces(
    extinction, transmittance, part, Select(isDense, All(1.0f), Lanes{}));
  const int count = isInPieces ? pieces.Count() : 1;
  for (int piece = 0; piece < count; ++piece)
  {
    add(isInPieces ? pieces.At(piece) : part);
  }
}

}

}

#endif
