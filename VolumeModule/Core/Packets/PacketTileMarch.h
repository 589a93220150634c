#ifndef Varimarch_Core_Packets_PacketTileMarch_h
#define Varimarch_Core_Packets_PacketTileMarch_h

// The packets of a tile, one by one, from their rays to their pixels, whatever they march through.
// Twin of FirstOpacity.glsl.

#include "Core/Packets/Cuts.h"
#include "Core/Packets/Looks.h"
#include "Core/Packets/PacketScene.h"
#include "Core/Packets/PacketTile.h"
#include "Core/Packets/Projections.h"
#include "Core/Packets/Rays.h"
#include "Core/Packets/ShaderMath.h"
#include "Core/Packets/Walk.h"

#include <cstddef>

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

/// A part of the rays of a packet, which is marched as a whole.
struct PacketPiece
{
  const PacketScene& scene;
  const PacketRays& rays;
  const PacketWalk& walk;
  const PacketSum& before; ///< the sum of what is in front of the rays
  int x;                   ///< the first pixel of the packet
  int y;
};

/// The march through one content of a tile, see PacketTile.h: a function Along(piece) that returns
/// the sum at the end of the rays, and LightOn(scene, x, y), which returns the light on the places
/// of a packet.
template <class Content>
struct MarchOf;

/// Marches what cropping, a mask and gaps leave of rays, in each block by its level.
/// @param x  and y: the first pixel of the packet
template <class Content>
PacketSum MarchLeft(
  const PacketScene& scene, const PacketRays& rays, const PacketSum& before, int x, int y)
{
  const auto marchLevel = [&](
                            const PacketScene& level, const PacketRays& piece, const PacketSum& sum)
  {
    const PacketWalk walk(level, piece, x, y);
    return MarchOf<Content>::Along({ level, piece, walk, sum, x, y });
  };
  const auto marchWhole = [&](const PacketRays& piece, const PacketSum& sum)
  {
    return scene.levels.scenes ? MarchByLevels(scene, piece, sum, marchLevel)
                               : marchLevel(scene, piece, sum);
  };
  const auto march = [&](const PacketRays& piece, const PacketSum& sum)
  {
    return scene.textures.gapTexture ? MarchAroundGaps(scene, piece, sum, marchWhole)
                                     : marchWhole(piece, sum);
  };
  const auto marchMasked = [&](const PacketRays& piece, const PacketSum& sum)
  {
    return scene.textures.maskTexture ? MarchPieces<MaskedPieces>(scene, piece, sum, march)
                                      : march(piece, sum);
  };
  return scene.rays.croppingRegions != 0
    ? MarchPieces<CroppedPieces>(scene, rays, before, marchMasked)
    : marchMasked(rays, before);
}

inline bool IsOfExtreme(const PacketScene& scene)
{
  return scene.rule == PacketRule::Extreme || scene.rule == PacketRule::ExtremeVoxel;
}

inline bool IsOfProjection(const PacketScene& scene)
{
  return scene.rule == PacketRule::Projection || scene.rule == PacketRule::RangeMean;
}

/// The colours of what rays have gathered.
inline PacketSum SeenOf(const PacketScene& scene, const PacketSum& march)
{
  if (IsOfExtreme(scene))
  {
    return SeenOfExtreme(scene, march);
  }
  return IsOfProjection(scene) ? SeenOfProjection(scene, march) : march;
}

template <class Content>
PacketSum SumOf(const PacketScene& scene, const PacketRays& rays, int x, int y)
{
  const PacketSum nothing = IsOfExtreme(scene) ? NothingFound() : PacketSum();
  return SeenOf(scene, MarchLeft<Content>(scene, rays, nothing, x, y));
}

/// The places [grid space] where rays first have an opacity, with 1 behind them; 0 for rays
/// without.
template <class Content>
Lanes4 LocatePacket(const PacketScene& scene, const PacketRays& rays, int x, int y)
{
  const PacketWalk walk(scene, rays, x, y);
  const auto march = [&](const PacketRays& piece, const PacketSum& before)
  { return MarchLeft<Content>(scene, piece, before, x, y); };
  const PacketLocation& location = scene.location;
  Lanes t = OpacityLocation(scene, rays, walk, location.opacity, march).Find();
  const LaneMask isRay = LaneMask(rays.enter < rays.exit);
  if (location.leastOpacity > 0.0f && Any(isRay & LaneMask(t == Never)))
  {
    const Lanes later = OpacityLocation(scene, rays, walk, location.leastOpacity, march).Find();
    t = Select(LaneMask(t == Never), later, t);
  }
  const LaneMask isShown = LaneMask(t < Never) | (isRay & AllInt(location.orExit ? -1 : 0));
  const Lanes3 place = rays.At(Min(t, rays.exit));
  const Lanes one = Select(isShown, All(1.0f), Lanes{});
  return { one * place.x, one * place.y, one * place.z, one };
}

inline Lanes4 ColorsOf(const PacketSum& sum)
{
  return { sum.color.x, sum.color.y, sum.color.z, 1.0f - sum.transmittance };
}

template <class Content>
Lanes4 DrawPacket(const PacketScene& scene, int x, int y)
{
  if (scene.receivers.places)
  {
    return MarchOf<Content>::LightOn(scene, x, y);
  }
  if (!IsVisible(scene.depths, x, y))
  {
    return ColorsOf(PacketSum());
  }
  const PacketRays rays = RaysOf(scene, x, y);
  if (!Any(LaneMask(rays.enter < rays.exit)))
  {
    return ColorsOf(PacketSum());
  }
  return scene.location.opacity > 0.0f ? LocatePacket<Content>(scene, rays, x, y)
                                       : ColorsOf(SumOf<Content>(scene, rays, x, y));
}

/// Stores the pixels of a packet that are asked for.
inline void Store(const Lanes4& drawn, int x, int y, const Viewport& pixels, float* rgba)
{
  const Numbers red(drawn.x);
  const Numbers green(drawn.y);
  const Numbers blue(drawn.z);
  const Numbers opacity(drawn.w);
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    const int column = x + lane % PacketWidth - pixels.left;
    const int row = y + lane / PacketWidth - pixels.bottom;
    if (column >= 0 && column < pixels.width && row >= 0 && row < pixels.height)
    {
      float* const pixel = rgba + 4 * (std::ptrdiff_t(row) * pixels.width + column);
      pixel[0] = red.of[lane];
      pixel[1] = green.of[lane];
      pixel[2] = blue.of[lane];
      pixel[3] = opacity.of[lane];
    }
  }
}

}

template <InstructionSet Set, class Content>
void MarchTile(const PacketScene& scene, const Viewport& pixels, const Viewport& tile, float* rgba)
{
  const int top = pixels.bottom + pixels.height;
  const int right = pixels.left + pixels.width;
  for (int y = tile.bottom; y < tile.bottom + tile.height && y < top; y += PacketRows)
  {
    for (int x = tile.left; x < tile.left + tile.width && x < right; x += PacketWidth)
    {
      if (x + PacketWidth > pixels.left && y + PacketRows > pixels.bottom)
      {
        Store(DrawPacket<Content>(scene, x, y), x, y, pixels, rgba);
      }
    }
  }
}

}

#endif
