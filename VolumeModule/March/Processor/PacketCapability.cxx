#include "March/Processor/PacketCapability.h"

#include "Core/Recipe/ShaderRecipe.h"
#include "March/Processor/PacketSceneBuilder.h"
#include "March/Processor/SoftwareRasterizer.h"

#include <algorithm>
#include <limits>

namespace varimarch
{

namespace
{

// True if packets have code for the blend mode. They have none for slices, for isosurfaces and sums
// without interpolation, and for extremes of splines.
bool IsBlendedByPackets(const RenderSettings& settings)
{
  const bool isComposite = settings.blend == Blend::Composite;
  const bool isExtreme = IsExtreme(settings.blend);
  const bool isSum = IsProjection(settings.blend) && !isExtreme;
  if (settings.nearest)
  {
    return isComposite || isExtreme;
  }
  return isComposite || isSum || (!settings.cubic && settings.blend != Blend::Slice);
}

// True if a mixture may be marched by midpoints, the only rule that packets have for it.
bool MayMixByMidpoints(const Frame& frame)
{
  const RenderSettings& settings = frame.settings;
  const bool mayChoose = frame.quality.choosesIntegration || settings.overlaps || settings.nearest;
  return settings.blend == Blend::Composite &&
    (mayChoose || settings.integration == Integration::Midpoint);
}

// True if packets have code for everything that a frame requests.
bool HasPacketRecipe(const Frame& frame)
{
  const RenderSettings& settings = frame.settings;
  const bool isPlain = settings.functionOf != FunctionOf::TwoValues;
  const bool isMixed = !IsMixture(frame) || MayMixByMidpoints(frame);
  const bool isMasked = settings.mask != Mask::None;
  const bool isLocated = frame.image.toImages || Locates(settings.pass);
  const bool hasMask = !isMasked || frame.voxels.mask.dimensions == frame.geometry.dimensions;
  const bool isSampledEvenly = !settings.uneven || (!isLocated && !settings.nearest);
  const bool hasPlaces = !isLocated || !IsProjection(settings.blend);
  const bool hasSteps = settings.acceleration != Acceleration::ScalarField;
  const bool hasRule = settings.blend != Blend::Composite || !IsSampled(settings) ||
    MarchesMaterial(settings) || settings.integration == Integration::Midpoint ||
    settings.integration == Integration::PreIntegrated;
  return IsBlendedByPackets(settings) && isPlain && isMixed && isSampledEvenly && hasPlaces &&
    hasMask && !settings.clippedGradients && hasSteps && hasRule && !settings.countFetches;
}

// True if 32 bits hold the index of every voxel.
bool CanBeIndexed(glm::ivec3 voxels, bool cubic)
{
  const int fewest = cubic ? 4 : 2;
  const double count = double(voxels.x) * voxels.y * voxels.z;
  return voxels.x >= fewest && voxels.y >= fewest && voxels.z >= fewest &&
    count < double(std::numeric_limits<int>::max());
}

// True if floats can represent the numbers directly. Shaders shift and scale numbers that are too
// large, too small or too far from zero.
bool IsPlain(const ScalarTexels& texels, vtkDataArray* array)
{
  if (texels.normalized)
  {
    constexpr double MostWhole = 1 << 24; // floats represent all integers up to this one
    const bool areFew = std::max(-texels.smallestScalar, texels.largestScalar) <= MostWhole;
    return areFew || PacketVoxelTypeOf(array);
  }
  constexpr double Large = 1e15;
  return texels.mapping.offset == 0.0 && texels.mapping.scale <= Large &&
    texels.mapping.scale >= 1.0 / Large;
}

bool HasPlainValues(const VolumeResources& volume)
{
  const VoxelComponents& components = volume.Blocks().Values().components;
  bool arePlain = true;
  for (std::size_t i = 0; i < components.size() && arePlain; ++i)
  {
    arePlain = IsPlain(volume.Blocks().TexelsOfComponents()[i], components[i].array);
  }
  return arePlain;
}

// True if packets can draw the gaps of a volume. Gradients next to gaps are left to shaders.
bool HasPlainGaps(const Frame& frame, VolumeResources& volume)
{
  const RenderSettings& settings = frame.settings;
  const bool isFinite = volume.Blocks().Texels().normalized || volume.Packets().AreFinite();
  const bool takesNoGradients = IsProjection(settings.blend) ||
    (settings.blend == Blend::Composite && !settings.shading && !settings.gradientOpacity &&
      settings.functionOf == FunctionOf::Value);
  const bool hasAny = frame.voxels.blanking.Any() || !isFinite;
  const bool mayHave = !settings.overlaps && !settings.uneven;
  return !hasAny || (mayHave && (isFinite || takesNoGradients));
}

// True if packets can read one of the volumes of a frame.
bool IsReadByPackets(const Frame& frame, VolumeResources& volume)
{
  return HasPacketRecipe(frame) && CanBeIndexed(frame.geometry.dimensions, frame.settings.cubic) &&
    HasPlainValues(volume) && HasPlainGaps(frame, volume);
}

}

// The voxels are examined last, because that takes time.
bool CanMarchByPackets(const Frame& frame, SceneResources& resources)
{
  const bool may = frame.device.mayMarchOnProcessor && IsSoftwareRasterizer() &&
    frame.device.mostMemoryBytes == 0 && frame.userCode.IsEmpty();
  if (!may || !IsReadByPackets(frame, resources.First()))
  {
    return false;
  }
  for (std::size_t i = 0; i < frame.others.size(); ++i)
  {
    if (!IsReadByPackets(frame.others[i], resources.Other(i)))
    {
      return false;
    }
  }
  return true;
}

}
