#include "Core/ShaderRecipe.h"

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
      return IsExtreme(settings.blend) ? "Step/BrickExtremes.glsl" : "Step/OpticalField.glsl";
    case Acceleration::Off:
      break;
  }
  return "Step/Fixed.glsl";
}

std::string BlendFile(Blend blend)
{
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
      break;
  }
  throw std::invalid_argument("Shader: there is none yet for isosurfaces");
}

std::string MarchFile(const RenderSettings& settings)
{
  if (settings.blend != Blend::Composite)
  {
    return IsExtreme(settings.blend) ? "March/Extreme.glsl" : "March/Projection.glsl";
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
  if (settings.blend != Blend::Composite)
  {
    parts.insert(parts.end(), { "Classify/OpticalTable.glsl" });
  }
  parts.insert(parts.end(),
    { BlendFile(settings.blend), WindowFile(settings), ResumeFile(settings.pass),
      "RayMarch.frag.glsl" });
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

std::vector<RenderSettings> RecipesOfPictures()
{
  std::vector<RenderSettings> recipes;
  for (RayPass pass : { RayPass::Upscaled, RayPass::Averaged })
  {
    for (bool sceneGeometry : { false, true })
    {
      recipes.push_back({ Blend::Composite, Acceleration::Off, false, sceneGeometry });
      recipes.back().pass = pass;
    }
  }
  for (Acceleration acceleration :
    { Acceleration::Off, Acceleration::ScalarField, Acceleration::OpticalField })
  {
    recipes.push_back({ Blend::Composite, acceleration });
    recipes.back().jitter = true;
    recipes.back().windowLevel = true;
  }
  return recipes;
}

std::vector<RenderSettings> RecipesWithGaps()
{
  std::vector<RenderSettings> recipes;
  for (const auto& [blend, shading] : { std::pair(Blend::Composite, false),
         std::pair(Blend::Composite, true), std::pair(Blend::MaximumIntensity, false) })
  {
    RenderSettings withGaps{ blend, Acceleration::Off, shading, false };
    withGaps.gaps = true;
    recipes.push_back(withGaps);
  }
  RenderSettings filled;
  filled.gaps = true;
  filled.fillGaps = true;
  recipes.push_back(filled);
  return recipes;
}

std::vector<RenderSettings> RecipesInBlocks()
{
  std::vector<RenderSettings> recipes;
  for (Blend blend : { Blend::Composite, Blend::MaximumIntensity, Blend::MinimumIntensity,
         Blend::AverageIntensity, Blend::Additive })
  {
    for (RayPass pass : { RayPass::Block, RayPass::Picture })
    {
      recipes.push_back({ blend, Acceleration::Off });
      recipes.back().pass = pass;
    }
  }
  return recipes;
}

std::vector<RenderSettings> RecipesOfMaterials()
{
  RenderSettings lit;
  lit.shading = true;
  lit.lights = true;
  RenderSettings gradient;
  gradient.gradientOpacity = true;
  RenderSettings litGradient = gradient;
  litGradient.shading = true;
  return { lit, gradient, litGradient };
}

std::vector<RenderSettings> RecipesWithCuts()
{
  std::vector<RenderSettings> recipes;
  for (const auto& [clipping, cropping] :
    { std::pair(true, false), std::pair(false, true), std::pair(true, true) })
  {
    recipes.emplace_back();
    recipes.back().clipping = clipping;
    recipes.back().cropping = cropping;
  }
  RenderSettings inBlocks = recipes.back();
  inBlocks.pass = RayPass::Block;
  recipes.push_back(inBlocks);
  inBlocks.pass = RayPass::Picture;
  recipes.push_back(inBlocks);
  return recipes;
}

std::vector<std::string> MaterialParts(const RenderSettings& settings)
{
  const std::string shade = !settings.shading ? "Shade/None.glsl"
    : settings.lights                         ? "Shade/Lights.glsl"
                                              : "Shade/HeadLight.glsl";
  return { "Gradient/CentralDifferences.glsl", shade,
    settings.gradientOpacity ? "GradientOpacity/Table.glsl" : "GradientOpacity/None.glsl",
    "Material/OneComponent.glsl" };
}

// Whether rays walk through bricks, or through cells with gaps.
bool Walks(const RenderSettings& settings)
{
  return settings.acceleration == Acceleration::OpticalField || settings.gaps;
}

bool FetchesFour(const std::string& marchFile)
{
  return marchFile == "March/Midpoint.glsl" || marchFile == "March/PreIntegrated.glsl";
}

}

bool UsesPreIntegration(const RenderSettings& settings)
{
  return settings.integration == Integration::PreIntegrated && settings.blend == Blend::Composite &&
    !MarchesMaterial(settings);
}

bool MarchesMaterial(const RenderSettings& settings)
{
  return settings.blend == Blend::Composite && (settings.shading || settings.gradientOpacity);
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
  parts.push_back(settings.cropping ? "Crop/Regions.glsl" : "Crop/None.glsl");
  parts.push_back(settings.countFetches ? "Probe/FetchCount.glsl" : "Probe/None.glsl");
  if (settings.pass == RayPass::Whole)
  {
    parts.push_back(WindowFile(settings));
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
  std::vector<std::string> parts = { "Slots.glsl", "Math/IntersectBox.glsl" };
  if (Walks(settings))
  {
    parts.push_back("Math/LatticeWalk.glsl");
  }
  parts.push_back("Math/Absorption.glsl");
  if (settings.gradientOpacity && MarchesMaterial(settings))
  {
    parts.push_back("Math/WithOpacityFactor.glsl");
  }
  parts.insert(parts.end(),
    { DepthFile(settings), ClipFile(settings),
      settings.jitter ? "Jitter/BlueNoise.glsl" : "Jitter/None.glsl", StepFile(settings),
      UsesPreIntegration(settings) ? "Classify/PreIntegrated.glsl"
                                   : "Classify/OpticalTable.glsl" });
  if (MarchesMaterial(settings))
  {
    const std::vector<std::string> material = MaterialParts(settings);
    parts.insert(parts.end(), material.begin(), material.end());
  }
  parts.push_back(BlendFile(settings.blend));
  const std::string march = MarchFile(settings);
  if (FetchesFour(march))
  {
    parts.push_back("Fetch/FourScalars.glsl");
  }
  parts.push_back(march);
  const std::vector<std::string> around = PartsAroundMarch(settings);
  parts.insert(parts.end(), around.begin(), around.end());
  return parts;
}

std::string VertexShaderPart()
{
  return "RayMarch.vert.glsl";
}

std::vector<RenderSettings> EveryRecipe()
{
  RenderSettings counting;
  counting.countFetches = true;
  std::vector<RenderSettings> recipes = { counting };
  for (const std::vector<RenderSettings>& others : { RecipesOfMaterials(), RecipesWithGaps(),
         RecipesInBlocks(), RecipesOfPictures(), RecipesWithCuts() })
  {
    recipes.insert(recipes.end(), others.begin(), others.end());
  }
  for (Acceleration acceleration :
    { Acceleration::Off, Acceleration::ScalarField, Acceleration::OpticalField })
  {
    for (bool sceneGeometry : { false, true })
    {
      for (Integration integration : { Integration::Midpoint, Integration::PreIntegrated,
             Integration::Simpson, Integration::PublishedSum })
      {
        recipes.push_back({ Blend::Composite, acceleration, false, sceneGeometry, integration });
      }
      recipes.push_back({ Blend::Composite, acceleration, true, sceneGeometry });
      for (Blend blend : { Blend::MaximumIntensity, Blend::MinimumIntensity,
             Blend::AverageIntensity, Blend::Additive })
      {
        if (acceleration != Acceleration::OpticalField || IsExtreme(blend))
        {
          recipes.push_back({ blend, acceleration, false, sceneGeometry });
        }
      }
    }
  }
  return recipes;
}

}
