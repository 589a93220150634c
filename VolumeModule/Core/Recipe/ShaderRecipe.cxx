#include "Core/Recipe/ShaderRecipe.h"

#include "Core/Recipe/MarchRecipe.h"
#include "Core/Recipe/MaterialRecipe.h"
#include "Core/Recipe/PassRecipe.h"

#include <algorithm>

namespace varimarch
{

namespace
{

std::string DepthFile(const RenderSettings& settings)
{
  return settings.sceneGeometry ? "Depth/SceneGeometry.glsl" : "Depth/None.glsl";
}

std::string ClipFile(const RenderSettings& settings)
{
  return settings.clipping ? "Clip/Planes.glsl" : "Clip/None.glsl";
}

std::string SpanFile(const RenderSettings& settings)
{
  return settings.limitsSpan ? "Span/Limited.glsl" : "Span/None.glsl";
}

std::string JitterFile(const RenderSettings& settings)
{
  return settings.jitter ? "Jitter/BlueNoise.glsl" : "Jitter/None.glsl";
}

std::string SpacingFile(const RenderSettings& settings)
{
  return settings.uneven ? "Spacing/Uneven.glsl" : "Spacing/Even.glsl";
}

std::string FilterFile(const RenderSettings& settings)
{
  return settings.filter == Filter::OfTexels ? "Filter/OfTexels.glsl" : "Filter/OfDevice.glsl";
}

// Light may take gradients from the device, if places beside each other are whole voxels apart.
std::string DifferenceFile(const RenderSettings& settings)
{
  const bool isForOpacity =
    settings.gradientOpacity || settings.functionOf == FunctionOf::ValueAndGradient;
  const bool mayRound = settings.filter == Filter::OfTexels && !isForOpacity && !settings.uneven;
  return mayRound ? "Difference/OfDevice.glsl" : "Difference/AsFiltered.glsl";
}

std::string ProbeFile(const RenderSettings& settings)
{
  return settings.countFetches ? "Probe/FetchCount.glsl" : "Probe/None.glsl";
}

using Parts = std::vector<std::string>;
const Parts PartsOfVolume = { "VolumeParameters.glsl", "VolumeTextures.glsl", "VolumeSlots.glsl" };

Parts PartsOfRays(const RenderSettings& settings)
{
  return { "RayParameters.glsl", "RayTextures.glsl", "Slots.glsl",
    settings.triesRays ? "Pixel/OfTrials.glsl" : "Pixel/OfImage.glsl" };
}

Parts PartsOfRaysAndVolume(const RenderSettings& settings)
{
  Parts parts = PartsOfRays(settings);
  parts.insert(parts.end(), PartsOfVolume.begin(), PartsOfVolume.end());
  return parts;
}

// A shader without a march: it finds the ray of each pixel and computes the pixel.
std::vector<std::string> PictureParts(const RenderSettings& settings)
{
  Parts parts = PartsOfRaysAndVolume(settings);
  parts.insert(parts.end(), { DepthFile(settings), ClipFile(settings) });
  if (IsProjection(settings.blend))
  {
    const std::vector<std::string> classify = ClassifyParts(settings);
    parts.insert(parts.end(), classify.begin(), classify.end());
  }
  parts.insert(parts.end(),
    { BlendFile(settings), WindowFile(settings), ResumeFile(settings.pass), SpanFile(settings),
      "RayMarch.frag.glsl" });
  return parts;
}

// A shader without a march: it computes pixels from an image of other rays.
std::vector<std::string> ResampledParts(const RenderSettings& settings)
{
  if (settings.pass == RayPass::Accumulated)
  {
    return { "RayParameters.glsl", "RayTextures.glsl", "Mean.frag.glsl" };
  }
  Parts parts = PartsOfRaysAndVolume(settings);
  parts.insert(parts.end(), { DepthFile(settings), ClipFile(settings) });
  parts.insert(
    parts.end(), { ResumeFile(settings.pass), SpanFile(settings), "RayMarch.frag.glsl" });
  return parts;
}

bool CastsShadows(const RenderSettings& settings)
{
  return settings.shading && settings.lights && settings.shadows;
}

// Files for rays from samples through the volume; empty if there are none.
std::vector<std::string> ThroughParts(const RenderSettings& settings)
{
  if (!CastsShadows(settings) && !settings.shadowsOthers && !IsInWayOfSky(settings))
  {
    return {};
  }
  return { "RaysInside.glsl", IsOfBoxes(settings) ? "Through/Voxels.glsl" : "Through/Segments.glsl",
    settings.overlaps ? "Around/Volumes.glsl" : "Around/None.glsl" };
}

// Files that determine the look of a scalar, and the files that they depend on.
std::vector<std::string> LookParts(const RenderSettings& settings)
{
  std::vector<std::string> parts;
  if (settings.blend == Blend::Isosurface)
  {
    parts = { GradientFile(settings), ShadeFile(settings) };
  }
  else
  {
    parts = ClassifyParts(settings);
  }
  if (MarchesMaterial(settings))
  {
    const std::vector<std::string> material = MaterialParts(settings);
    parts.insert(parts.end(), material.begin(), material.end());
  }
  const std::vector<std::string> through = ThroughParts(settings);
  parts.insert(parts.end(), through.begin(), through.end());
  if (settings.shading && settings.lights)
  {
    const std::vector<std::string> light = LightParts(settings);
    parts.insert(parts.end(), light.begin(), light.end());
  }
  if (settings.shading && (settings.blend == Blend::Isosurface || MarchesMaterial(settings)))
  {
    parts.push_back(settings.damping ? "Damping/Homogeneous.glsl" : "Damping/None.glsl");
  }
  return parts;
}

// Files for the positions of voxels and the values between them.
std::vector<std::string> VoxelParts(const RenderSettings& settings)
{
  return { SpacingFile(settings), FilterFile(settings), DifferenceFile(settings),
    settings.cubic ? "Interpolation/CubicSpline.glsl" : "Interpolation/Linear.glsl" };
}

}

bool UsesPreIntegration(const RenderSettings& settings)
{
  return settings.integration == Integration::PreIntegrated && settings.blend == Blend::Composite &&
    IsSampled(settings) && !MarchesMaterial(settings);
}

int PartCount(const RenderSettings& settings)
{
  return settings.components == Components::Independent ? settings.componentCount : 1;
}

bool FillsGaps(const RenderSettings& settings)
{
  return settings.gaps && settings.fillGaps && settings.blend == Blend::Composite;
}

// Files that select the parts of a ray to march and process the result.
static std::vector<std::string> PartsAroundMarch(const RenderSettings& settings)
{
  std::vector<std::string> parts;
  if (settings.gaps)
  {
    parts.push_back(FillsGaps(settings) ? "Fill/Color.glsl" : "Fill/None.glsl");
  }
  parts.push_back(settings.gaps ? "Gaps/Cells.glsl" : "Gaps/None.glsl");
  parts.push_back(settings.mask == Mask::None ? "Mask/None.glsl" : "Mask/Voxels.glsl");
  parts.push_back(settings.cropping ? "Crop/Regions.glsl" : "Crop/None.glsl");
  parts.push_back(ProbeFile(settings));
  const std::vector<std::string> pass = PassParts(settings);
  parts.insert(parts.end(), pass.begin(), pass.end());
  parts.insert(parts.end(), { SpanFile(settings), "RayMarch.frag.glsl" });
  return parts;
}

// The files of one of several overlapping volumes; see Shaders/VolumeSlots.glsl.
static std::vector<std::string> PartsOfOne(const RenderSettings& settings)
{
  Parts parts = PartsOfVolume;
  const auto add = [&](const std::vector<std::string>& more)
  { parts.insert(parts.end(), more.begin(), more.end()); };
  add(VoxelParts(settings));
  add({ ProbeFile(settings), "Gaps/None.glsl" });
  add(LookParts(settings));
  add({ StepFile(settings) });
  add(SkyParts(settings));
  add({ settings.nearest ? "Reading/Voxels.glsl" : "Reading/Cells.glsl", "Volumes/Next.glsl" });
  return parts;
}

static std::vector<std::string> PartsOfSeveral(const RenderSettings& settings)
{
  Parts parts = PartsOfRays(settings);
  const auto add = [&](const std::vector<std::string>& more)
  { parts.insert(parts.end(), more.begin(), more.end()); };
  add({ DepthFile(settings), ClipFile(settings), JitterFile(settings), BlendFile(settings),
    "Volumes/None.glsl" });
  const bool areInLight = settings.shadowsOthers || settings.occludesOthers;
  if (areInLight)
  {
    parts.push_back("DepthOfNone.glsl");
  }
  for (const RenderSettings& other : settings.others)
  {
    add(PartsOfOne(other));
  }
  add(PartsOfOne(settings));
  if (areInLight)
  {
    parts.push_back("DepthOfAll.glsl");
  }
  add({ "March/Several.glsl", "Mask/None.glsl", "Crop/None.glsl" });
  add(PassParts(settings));
  add({ SpanFile(settings), "RayMarch.frag.glsl" });
  return parts;
}

std::vector<std::string> FragmentShaderParts(const RenderSettings& settings)
{
  if (settings.role == ShaderRole::LightPlaces)
  {
    return LightPlacesParts(settings);
  }
  if (settings.pass == RayPass::Picture)
  {
    return PictureParts(settings);
  }
  if (settings.role != ShaderRole::MarchRays)
  {
    return PacketParts(settings);
  }
  if (!Marches(settings))
  {
    return ResampledParts(settings);
  }
  if (!settings.others.empty())
  {
    return PartsOfSeveral(settings);
  }
  Parts parts = PartsOfRaysAndVolume(settings);
  const auto add = [&](const std::vector<std::string>& more)
  { parts.insert(parts.end(), more.begin(), more.end()); };
  add(VoxelParts(settings));
  add({ DepthFile(settings), ClipFile(settings) });
  if (settings.blend != Blend::Slice || Locates(settings.pass))
  {
    add({ JitterFile(settings), StepFile(settings) });
  }
  add(LookParts(settings));
  parts.push_back(BlendFile(settings));
  add(MarchParts(settings));
  add(PartsAroundMarch(settings));
  return parts;
}

bool ReadsStoredGradients(const RenderSettings& settings)
{
  RenderSettings march = settings;
  march.pass = RayPass::Whole;
  march.role = ShaderRole::MarchRays;
  const Parts parts = FragmentShaderParts(march);
  return std::find(parts.begin(), parts.end(), "Gradient/Stored.glsl") != parts.end();
}

}
