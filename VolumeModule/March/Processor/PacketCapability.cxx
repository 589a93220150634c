#include "March/Processor/PacketCapability.h"

#include "Core/Packets/PacketTwins.h"
#include "Core/Recipe/MarchRecipe.h"
#include "Core/Recipe/ShaderRecipe.h"
#include "March/Processor/PacketSceneBuilder.h"
#include "March/Processor/SoftwareRasterizer.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace varimarch
{

namespace
{

// True if a shader file does nothing, something that a shader does for rays of packets too, or
// something in which devices differ and packets do not.
bool NeedsNoTwin(const std::string& file)
{
  static const std::set<std::string> nothing = { "None", "NoneOfAll", "Even" };
  static const std::set<std::string> slotsOfDevice = { "Difference", "Filter", "Locate", "Peel",
    "Pixel", "Resume", "Window" };
  const std::size_t slash = file.find('/');
  return slash == std::string::npos || slotsOfDevice.count(file.substr(0, slash)) > 0 ||
    nothing.count(file.substr(slash + 1, file.rfind('.') - slash - 1)) > 0;
}

// Twins that packets cannot combine: sums without interpolation, and what knows no splines.
bool AreApart(const std::set<std::string>& files)
{
  static const std::vector<std::pair<std::string, std::string>> pairs = {
    { "March/ProjectedVoxels.glsl", "Blend/AverageIntensity.glsl" },
    { "March/ProjectedVoxels.glsl", "Blend/Additive.glsl" },
    { "March/Projection.glsl", "Blend/MaximumIntensity.glsl" },
    { "March/Projection.glsl", "Blend/MinimumIntensity.glsl" },
    { "March/Isosurfaces.glsl", "Interpolation/CubicSpline.glsl" },
  };
  return std::any_of(pairs.begin(), pairs.end(),
    [&](const auto& pair) { return files.count(pair.first) > 0 && files.count(pair.second) > 0; });
}

// The files of the shader that would march.
std::vector<std::string> PartsOfMarch(RenderSettings settings)
{
  settings.role = ShaderRole::MarchRays;
  settings.pass = Marches(settings) ? settings.pass : RayPass::Whole;
  return FragmentShaderParts(settings);
}

// True if packets repeat all files of the shader that would march.
bool HasTwins(const RenderSettings& settings)
{
  const std::vector<std::string> parts = PartsOfMarch(settings);
  const std::set<std::string>& twins = ShaderFilesOfPackets();
  return !AreApart({ parts.begin(), parts.end() }) &&
    std::all_of(parts.begin(), parts.end(),
      [&](const std::string& file) { return NeedsNoTwin(file) || twins.count(file) > 0; });
}

// True if packets march a mixture; they do so by midpoints only.
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
  const bool isMixed = !IsMixture(frame) || MayMixByMidpoints(frame);
  const bool isLocated = frame.image.toImages || Locates(settings.pass);
  const bool hasMask =
    settings.mask == Mask::None || frame.voxels.mask.dimensions == frame.geometry.dimensions;
  const bool isSampledEvenly = !settings.uneven || (!isLocated && !settings.nearest);
  const bool hasPlaces = !isLocated || !IsProjection(settings.blend);
  return HasTwins(settings) && isMixed && isSampledEvenly && hasPlaces && hasMask;
}

bool IsFinite(VolumeResources& volume)
{
  return volume.Blocks().Texels().normalized || volume.Packets().AreFinite();
}

bool HasNoGaps(const Frame& frame, VolumeResources& volume)
{
  return !frame.voxels.blanking.Any() && IsFinite(volume);
}

// True if packets can number the voxels: those in memory by 64 bits, everything that belongs to
// voxels besides them by 32.
bool CanBeIndexed(const Frame& frame, VolumeResources& volume)
{
  const RenderSettings& settings = frame.settings;
  const bool hasOnlyVoxels =
    !settings.cubic && settings.mask == Mask::None && !settings.overlaps && !IsMixture(frame);
  return IsIndexedBy32Bits(frame.geometry.dimensions) ||
    (hasOnlyVoxels && HasNoGaps(frame, volume));
}

// True if packets can read the voxels although one may be alone along an axis, where it is there
// twice. Masks and gaps have the places of voxels in memory.
bool IsThickEnough(const Frame& frame, VolumeResources& volume)
{
  const glm::ivec3& voxels = frame.geometry.dimensions;
  const int fewest = std::min({ voxels.x, voxels.y, voxels.z });
  const RenderSettings& settings = frame.settings;
  const bool hasVoxelsAlone =
    settings.mask == Mask::None && !settings.uneven && HasNoGaps(frame, volume);
  return settings.cubic ? fewest >= 4 : fewest >= 2 || hasVoxelsAlone;
}

// Coarser levels of a volume are read as they are.
bool AreLevelsPlain(const Frame& frame, const VolumeResources& volume)
{
  const std::vector<TexelMapping>& mappings = volume.Packets().Mappings();
  return !frame.blockLevels ||
    std::all_of(mappings.begin(), mappings.end(),
      [](const TexelMapping& mapping) { return mapping == TexelMapping(); });
}

bool TakesGradients(const RenderSettings& settings)
{
  const std::vector<std::string> parts = PartsOfMarch(settings);
  return std::any_of(parts.begin(), parts.end(),
    [](const std::string& file) { return file.rfind("Gradient/", 0) == 0 && !NeedsNoTwin(file); });
}

// True if packets can draw the gaps of a volume. Gradients next to gaps are left to shaders.
bool HasPlainGaps(const Frame& frame, VolumeResources& volume)
{
  const RenderSettings& settings = frame.settings;
  const bool mayHave = !settings.overlaps && !settings.uneven;
  return HasNoGaps(frame, volume) || (mayHave && (IsFinite(volume) || !TakesGradients(settings)));
}

// True if packets can read one of the volumes of a frame.
bool IsReadByPackets(const Frame& frame, VolumeResources& volume)
{
  return HasPacketRecipe(frame) && AreLevelsPlain(frame, volume) && CanBeIndexed(frame, volume) &&
    IsThickEnough(frame, volume) && HasPlainGaps(frame, volume);
}

}

// Packets keep the light of places from one image to the next, and take it from there. A shader
// marches a ray to each light from each sample, and takes seconds to compile: Decision 0047. A
// bound of the graphics memory is about the device, which then draws whatever it can.
bool ShouldMarchByPackets(const Frame& frame)
{
  const bool isForSoftware = IsSoftwareRasterizer() && frame.device.mostMemoryBytes == 0;
  return isForSoftware || IsInWayOfLights(frame.settings) || IsInWayOfSky(frame.settings);
}

// The voxels are examined last, because that takes time.
bool CanMarchByPackets(const Frame& frame, SceneResources& resources)
{
  const bool may = frame.device.mayMarchOnProcessor && frame.userCode.IsEmpty();
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
