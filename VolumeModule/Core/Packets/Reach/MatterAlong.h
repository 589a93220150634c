#ifndef Varimarch_Core_Packets_Reach_MatterAlong_h
#define Varimarch_Core_Packets_Reach_MatterAlong_h

// The matter that takes light along rays of any origin.

#include "Core/Fields/GapField.h"
#include "Core/Packets/Crop/Regions.h"
#include "Core/Packets/Mask/Voxels.h"
#include "Core/Packets/Material/LabelLooks.h"
#include "Core/Packets/Material/OneComponent.h"
#include "Core/Packets/PacketLattice.h"

namespace varimarch
{

namespace
{

/// The matter that cropping, a mask and gaps leave along rays that are followed forwards.
class MatterAlong
{
public:
  MatterAlong(const PacketScene& scene, const PacketRays& rays)
    : scene(scene)
    , rays(rays)
    , material(scene, rays)
    , looks(scene)
    , mask(scene, rays)
    , isCut(
        scene.rays.croppingRegions != 0 || scene.textures.maskTexture || scene.textures.gapTexture)
  {
  }

  /// Goes on to t. Returns the next place at which cropping or the mask may cut the rays.
  /// @param isAsked  the rays that matter
  Lanes GoTo(Lanes t, LaneMask isAsked)
  {
    return this->isCut ? this->GoToCut(t, isAsked) : All(Never);
  }

  /// The rays with matter at a place, which lies before the next cut.
  LaneMask IsLeft(Lanes place) const
  {
    return this->isCut ? this->IsLeftByCuts(place) : LaneMask(place == place);
  }

  /// True if extinction depends on values alone.
  bool IsOfValues() const
  {
    return !this->scene.textures.gradientOpacityTable && !this->scene.textures.twoValueTable;
  }

  /// The extinction of values where the rays are [1/mm].
  Lanes ExtinctionOf(Lanes value, const Lanes3& gradient) const
  {
    if (this->scene.labelRows)
    {
      return this->ExtinctionOfLabels(value, gradient);
    }
    const Lanes extinction = this->IsOfValues() ? varimarch::ExtinctionOf(this->scene.look, value)
                                                : this->ExtinctionBy(value, gradient);
    const float weight = this->scene.parameters.partWeights[this->scene.constituent.component];
    return Min(weight * extinction, All(this->scene.shadows.mostExtinction));
  }

  /// The mean extinction of values that change linearly from one to another [1/mm].
  Lanes MeanExtinctionOf(Lanes start, Lanes end, const Lanes3& gradient) const
  {
    if (this->scene.look.sums && !this->scene.labelRows && this->IsOfValues())
    {
      const Lanes most = All(this->scene.shadows.mostExtinction);
      const float weight = this->scene.parameters.partWeights[this->scene.constituent.component];
      return Min(weight * varimarch::MeanExtinctionOf(this->scene.look, start, end, most), most);
    }
    constexpr int Parts = 4;
    Lanes sum = {};
    for (int part = 0; part < Parts; ++part)
    {
      sum = sum + this->ExtinctionOf(Mix(start, end, All((float(part) + 0.5f) / Parts)), gradient);
    }
    return (1.0f / Parts) * sum;
  }

private:
  // What few scenes have is not inlined into the march of rays, of which there are several copies.
  [[gnu::noinline]] Lanes GoToCut(Lanes t, LaneMask isAsked)
  {
    Lanes face = All(Never);
    if (this->scene.textures.maskTexture)
    {
      face = this->mask.GoTo(t, isAsked);
    }
    return this->scene.rays.croppingRegions != 0
      ? Min(face, CroppedPieces(this->scene, this->rays).NextCrossing(t))
      : face;
  }

  [[gnu::noinline]] LaneMask IsLeftByCuts(Lanes place) const
  {
    LaneMask isLeft = LaneMask(place == place);
    if (this->scene.rays.croppingRegions != 0)
    {
      isLeft &= CroppedPieces(this->scene, this->rays).IsDrawn(place);
    }
    if (this->scene.textures.maskTexture)
    {
      isLeft &= LaneMask(FloatOf(this->mask.Content()) > this->scene.parameters.leastContent);
    }
    if (const auto* const texels = this->scene.textures.gapTexture.template Texels<std::uint8_t>())
    {
      const VolumeParameters& p = this->scene.parameters;
      const PacketLattice cells(this->rays, 1.0f, -p.gapShift, glm::ivec3(p.gapCellCount));
      const IntNumbers index = cells.IndexOf(cells.At(place).cell);
      const IntLanes texel =
        IntLanesOf([&](int lane) { return std::int32_t(texels[index.of[lane]]); });
      isLeft &= (texel != GapField::NoValue) & (texel != GapField::LeftOut);
    }
    return isLeft;
  }

  [[gnu::noinline]] FLATTENED Lanes ExtinctionBy(Lanes value, const Lanes3& gradient) const
  {
    return this->material.LookOf(value, gradient).extinction;
  }

  [[gnu::noinline]] Lanes ExtinctionOfLabels(Lanes value, const Lanes3& gradient) const
  {
    return Min(this->looks.Of(this->mask.Content(), value, gradient).extinction,
      All(this->scene.shadows.mostExtinction));
  }

  const PacketScene& scene;
  const PacketRays& rays;
  PacketMaterial material;
  LabelLooks looks;
  MaskWalk mask;
  bool isCut; ///< true if cropping, a mask or gaps may take matter away
};

}

}

#endif
