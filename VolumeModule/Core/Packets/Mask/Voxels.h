#ifndef Varimarch_Core_Packets_Mask_Voxels_h
#define Varimarch_Core_Packets_Mask_Voxels_h

// Twin of Mask/Voxels.glsl.

#include "Core/Packets/PacketLattice.h"

namespace varimarch
{

namespace
{

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

}

}

#endif
