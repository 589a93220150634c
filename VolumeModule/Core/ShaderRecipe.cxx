#include "Core/ShaderRecipe.h"

#include "Core/MaterialRecipe.h"

#include <stdexcept>
#include <utility>

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

std::string StepFile(const RenderSettings& settings)
{
  switch (settings.acceleration)
  {
    case Acceleration::ScalarField:
      return "Step/VariationField.glsl";
    case Acceleration::OpticalField:
      if (IsExtreme(settings.blend))
      {
        return "Step/BrickExtremes.glsl";
      }
      return settings.skipsBricks ? "Step/OpticalField.glsl" : "Step/Growing.glsl";
    case Acceleration::Off:
      break;
  }
  return "Step/Fixed.glsl";
}

std::string ComponentBlendFile(Blend blend)
{
  switch (blend)
  {
    case Blend::MaximumIntensity:
    case Blend::MinimumIntensity:
      return "Blend/ComponentExtreme.glsl";
    case Blend::AverageIntensity:
      return "Blend/ComponentAverage.glsl";
    default:
      return "Blend/ComponentAdditive.glsl";
  }
}

std::string BlendFile(const RenderSettings& settings)
{
  const Blend blend = settings.blend;
  if (settings.components != Components::One && IsProjection(blend))
  {
    return ComponentBlendFile(blend);
  }
  switch (blend)
  {
    case Blend::Composite:
      return "Blend/Composite.glsl";
    case Blend::MaximumIntensity:
      return "Blend/MaximumIntensity.glsl";
    case Blend::MinimumIntensity:
      return "Blend/MinimumIntensity.glsl";
    case Blend::AverageIntensity:
      return "Blend/AverageIntensity.glsl";
    case Blend::Additive:
      return "Blend/Additive.glsl";
    case Blend::Isosurface:
    case Blend::Slice:
      return "Blend/Composite.glsl"; // of surfaces, each of an optical depth
  }
  throw std::invalid_argument("Shader: unknown blend mode");
}

std::string MarchFile(const RenderSettings& settings)
{
  if (settings.blend == Blend::Isosurface)
  {
    return settings.nearest ? "March/VoxelSurfaces.glsl" : "March/Isosurfaces.glsl";
  }
  if (settings.blend == Blend::Slice)
  {
    return "March/Slice.glsl";
  }
  if (IsProjection(settings.blend) && settings.components != Components::One)
  {
    return "March/Projection.glsl";
  }
  if (settings.nearest && !settings.uneven)
  {
    return MarchesMaterial(settings) ? "March/MaterialVoxels.glsl" : "March/Voxels.glsl";
  }
  if (settings.blend != Blend::Composite)
  {
    return IsSampled(settings) ? "March/Projection.glsl" : "March/Extreme.glsl";
  }
  if (MarchesMaterial(settings))
  {
    return "March/MaterialSegments.glsl";
  }
  switch (settings.integration)
  {
    case Integration::PreIntegrated:
      return "March/PreIntegrated.glsl";
    case Integration::Simpson:
      return "March/Simpson.glsl";
    case Integration::PublishedSum:
      return "March/PublishedSum.glsl";
    case Integration::Midpoint:
      break;
  }
  return "March/Midpoint.glsl";
}

std::vector<std::string> MaskParts(Mask mask)
{
  switch (mask)
  {
    case Mask::Binary:
      return { "Region/Named.glsl", "Mask/Voxels.glsl" };
    case Mask::Labels:
      return { "Region/Labels.glsl", "Mask/Voxels.glsl" };
    case Mask::None:
      break;
  }
  return { "Mask/None.glsl" };
}

std::string ResumeFile(RayPass pass)
{
  switch (pass)
  {
    case RayPass::Block:
      return "Resume/Block.glsl";
    case RayPass::Picture:
      return "Resume/Picture.glsl";
    case RayPass::Upscaled:
      return "Resume/Upscaled.glsl";
    case RayPass::Averaged:
      return "Resume/Averaged.glsl";
    case RayPass::PeelOutside:
      return "Resume/PeelOutside.glsl";
    case RayPass::PeelBetween:
      return "Resume/PeelBetween.glsl";
    case RayPass::PeelLast:
      return "Resume/PeelLast.glsl";
    case RayPass::PickProp:
      return "Resume/PickProp.glsl";
    case RayPass::PickVoxel:
      return "Resume/PickVoxel.glsl";
    case RayPass::FirstDepth:
      return "Resume/FirstDepth.glsl";
    case RayPass::Whole:
      break;
  }
  return "Resume/Whole.glsl";
}

std::string WindowFile(const RenderSettings& settings)
{
  return settings.windowLevel ? "Window/WindowLevel.glsl" : "Window/None.glsl";
}

// No march: only where the rays are that have a pixel, and what it becomes.
std::vector<std::string> PictureParts(const RenderSettings& settings)
{
  std::vector<std::string> parts = { "Slots.glsl", "Math/IntersectBox.glsl", "Math/Absorption.glsl",
    DepthFile(settings), ClipFile(settings) };
  if (IsProjection(settings.blend))
  {
    const std::vector<std::string> classify = ClassifyParts(settings);
    parts.insert(parts.end(), classify.begin(), classify.end());
  }
  parts.insert(parts.end(),
    { BlendFile(settings), WindowFile(settings), ResumeFile(settings.pass), "RayMarch.frag.glsl" });
  return parts;
}

// Nor here: pixels of a picture of other rays, whose colours it has.
std::vector<std::string> ResampledParts(const RenderSettings& settings)
{
  std::vector<std::string> parts = { "Slots.glsl", "Math/IntersectBox.glsl", DepthFile(settings),
    ClipFile(settings) };
  if (settings.pass == RayPass::Upscaled)
  {
    parts.push_back(settings.sceneGeometry ? "Edges/SceneGeometry.glsl" : "Edges/None.glsl");
  }
  parts.insert(parts.end(), { ResumeFile(settings.pass), "RayMarch.frag.glsl" });
  return parts;
}

// How a scalar gets its look, and what its look depends on.
std::vector<std::string> LookParts(const RenderSettings& settings)
{
  if (settings.blend == Blend::Isosurface)
  {
    return { GradientFile(settings), ShadeFile(settings) };
  }
  std::vector<std::string> parts = ClassifyParts(settings);
  if (MarchesMaterial(settings))
  {
    const std::vector<std::string> material = MaterialParts(settings);
    parts.insert(parts.end(), material.begin(), material.end());
  }
  return parts;
}

// The march and what it calls.
std::vector<std::string> MarchParts(const RenderSettings& settings)
{
  const std::string march = MarchFile(settings);
  std::vector<std::string> parts;
  if (settings.blend == Blend::Isosurface)
  {
    parts.push_back("Surface/Isosurfaces.glsl");
  }
  if (march == "March/Voxels.glsl")
  {
    parts.push_back(
      settings.blend == Blend::Composite ? "Voxel/Homogeneous.glsl" : "Voxel/Projected.glsl");
  }
  if (march == "March/Projection.glsl")
  {
    parts.push_back(
      settings.components == Components::One ? "Sample/Scalar.glsl" : "Sample/Texel.glsl");
  }
  if (march == "March/Midpoint.glsl" || march == "March/PreIntegrated.glsl")
  {
    parts.push_back("Fetch/FourScalars.glsl");
  }
  parts.push_back(march);
  return parts;
}

// Whether rays walk through bricks, voxels, or cells.
bool Walks(const RenderSettings& settings)
{
  return StepFile(settings) == "Step/OpticalField.glsl" ||
    StepFile(settings) == "Step/BrickExtremes.glsl" || settings.gaps ||
    settings.mask != Mask::None || (!IsSampled(settings) && settings.blend != Blend::Slice);
}

// What every march begins with: where voxels are, and what lies between them.
std::vector<std::string> VoxelParts(const RenderSettings& settings)
{
  std::vector<std::string> parts = { "Slots.glsl", "Math/IntersectBox.glsl",
    settings.uneven ? "Spacing/Uneven.glsl" : "Spacing/Even.glsl" };
  if (settings.cubic)
  {
    parts.push_back("Math/CubicSpline.glsl");
  }
  parts.push_back(settings.cubic ? "Interpolation/CubicSpline.glsl" : "Interpolation/Linear.glsl");
  return parts;
}

// How long the next step is.
std::vector<std::string> StepParts(const RenderSettings& settings)
{
  const std::string jitter = settings.jitter ? "Jitter/BlueNoise.glsl" : "Jitter/None.glsl";
  if (settings.acceleration == Acceleration::OpticalField && !IsExtreme(settings.blend))
  {
    return { "Math/StepGrowth.glsl", jitter, StepFile(settings) };
  }
  return { jitter, StepFile(settings) };
}

}

bool UsesPreIntegration(const RenderSettings& settings)
{
  return settings.integration == Integration::PreIntegrated && settings.blend == Blend::Composite &&
    IsSampled(settings) && !MarchesMaterial(settings);
}

bool MarchesMaterial(const RenderSettings& settings)
{
  const bool isComposite = settings.blend == Blend::Composite;
  return settings.blend == Blend::Slice ||
    (isComposite &&
      (settings.shading || settings.gradientOpacity || settings.components != Components::One ||
        settings.functionOf != FunctionOf::Value || settings.mask == Mask::Labels));
}

int PartCount(const RenderSettings& settings)
{
  return settings.components == Components::Independent ? settings.componentCount : 1;
}

bool UsesGradients(const RenderSettings& settings)
{
  return (settings.blend == Blend::Composite || settings.blend == Blend::Slice) &&
    (settings.shading || settings.gradientOpacity);
}

bool FillsGaps(const RenderSettings& settings)
{
  return settings.gaps && settings.fillGaps && settings.blend == Blend::Composite;
}

// Which parts of a ray are marched, and what becomes of its result.
static std::vector<std::string> PartsAroundMarch(const RenderSettings& settings)
{
  std::vector<std::string> parts;
  if (settings.gaps)
  {
    parts.push_back(FillsGaps(settings) ? "Fill/Color.glsl" : "Fill/None.glsl");
  }
  parts.push_back(settings.gaps ? "Gaps/Cells.glsl" : "Gaps/None.glsl");
  const std::vector<std::string> mask = MaskParts(settings.mask);
  parts.insert(parts.end(), mask.begin(), mask.end());
  parts.push_back(settings.cropping ? "Crop/Regions.glsl" : "Crop/None.glsl");
  parts.push_back(settings.countFetches ? "Probe/FetchCount.glsl" : "Probe/None.glsl");
  if (settings.pass == RayPass::Whole || Peels(settings.pass))
  {
    parts.push_back(WindowFile(settings));
  }
  if (Peels(settings.pass))
  {
    parts.push_back("Peel/Segment.glsl");
  }
  if (Locates(settings.pass))
  {
    parts.push_back("Locate/Opacity.glsl");
  }
  parts.insert(parts.end(), { ResumeFile(settings.pass), "RayMarch.frag.glsl" });
  return parts;
}

std::vector<std::string> FragmentShaderParts(const RenderSettings& settings)
{
  if (settings.pass == RayPass::Picture)
  {
    return PictureParts(settings);
  }
  if (!Marches(settings.pass))
  {
    return ResampledParts(settings);
  }
  std::vector<std::string> parts = VoxelParts(settings);
  if (Walks(settings))
  {
    parts.push_back("Math/LatticeWalk.glsl");
  }
  parts.push_back("Math/Absorption.glsl");
  const bool opacityIsComputed = settings.gradientOpacity ||
    settings.functionOf != FunctionOf::Value || settings.mask == Mask::Labels;
  if (opacityIsComputed && MarchesMaterial(settings))
  {
    parts.push_back("Math/WithOpacityFactor.glsl");
  }
  const std::string march = MarchFile(settings);
  if (march == "March/Isosurfaces.glsl" || march == "March/Extreme.glsl")
  {
    parts.push_back("Math/CellCubic.glsl");
  }
  const auto add = [&](const std::vector<std::string>& more)
  { parts.insert(parts.end(), more.begin(), more.end()); };
  add({ DepthFile(settings), ClipFile(settings) });
  if (settings.blend != Blend::Slice || Locates(settings.pass))
  {
    add(StepParts(settings));
  }
  add(LookParts(settings));
  parts.push_back(BlendFile(settings));
  add(MarchParts(settings));
  add(PartsAroundMarch(settings));
  return parts;
}

std::string VertexShaderPart()
{
  return "RayMarch.vert.glsl";
}

}
