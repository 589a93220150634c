#ifndef Varimarch_Core_Packets_LabelLight_Labels_h
#define Varimarch_Core_Packets_LabelLight_Labels_h

// Twin of LabelLight/Labels.glsl and LabelLight/Scalars.glsl.

#include "Core/Packets/PacketLattice.h"

namespace varimarch
{

namespace
{

/// A smaller square of a gradient is rounding.
constexpr float LeastSurface = 1e-6f;

/// The surfaces of the labels in a mask, whose voxels are those of the volume.
class LabelSurfaces
{
public:
  LabelSurfaces(const PacketScene& scene, const PacketRays& rays)
    : texels(scene.textures.maskTexture.Texels<std::uint16_t>())
    , rays(rays)
    , lattice(rays, 1.0f, -0.5f, scene.volume.voxelCount)
  {
  }

  /// The gradient of the part of space that the labels of the rays fill, per voxel.
  Lanes3 GradientAt(const Lanes3& place) const
  {
    const IntLanes reach = this->TexelsAt(Floor(place + 0.5f), 1);
    if (!Any(reach < 3))
    {
      return Lanes3(0.0f);
    }
    const auto along = [&](float x, float y, float z)
    {
      const Lanes3 step = { All(x), All(y), All(z) };
      return this->LabelledPart(place + step) - this->LabelledPart(place - step);
    };
    const Lanes3 gradient = { along(1.0f, 0.0f, 0.0f), along(0.0f, 1.0f, 0.0f),
      along(0.0f, 0.0f, 1.0f) };
    return Select(LaneMask(reach < 3), gradient, Lanes3(0.0f));
  }

  /// The rows of the labels at places.
  IntLanes RowsAt(const Lanes3& place) const { return this->TexelsAt(Floor(place + 0.5f), 0); }

private:
  Lanes LabelledPart(const Lanes3& place) const
  {
    const Lanes3 low = Floor(place);
    const Lanes3 part = place - low;
    Lanes filled = All(0.0f);
    for (int corner = 0; corner < 8; ++corner)
    {
      const bool x = (corner & 1) != 0;
      const bool y = (corner >> 1 & 1) != 0;
      const bool z = corner >> 2 != 0;
      const Lanes weight =
        (x ? part.x : 1.0f - part.x) * (y ? part.y : 1.0f - part.y) * (z ? part.z : 1.0f - part.z);
      const Lanes3 side = { All(float(x)), All(float(y)), All(float(z)) };
      const IntLanes content = this->TexelsAt(low + side, 0);
      filled += Select(LaneMask(content == this->rays.region), weight, All(0.0f));
    }
    return filled;
  }

  IntLanes TexelsAt(const Lanes3& voxel, int which) const
  {
    const IntNumbers index = this->lattice.IndexOf(voxel);
    return IntLanesOf([&](int lane)
      { return std::int32_t(this->texels[2 * std::ptrdiff_t(index.of[lane]) + which]); });
  }

  const std::uint16_t* texels;
  const PacketRays& rays;
  PacketLattice lattice;
};

}

}

#endif
