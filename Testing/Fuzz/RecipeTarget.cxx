// Shaders of random settings that the mapper can ask for, compiled by the reference compiler.
#include "Fuzz/FuzzInput.h"
#include "Fuzz/FuzzTarget.h"
#include "Shader/ShaderValidation.h"

#include "Core/Recipe/PassRecipe.h"
#include "Core/Recipe/ShaderAssembly.h"
#include "Core/Recipe/ShaderRecipe.h"

#include <algorithm>
#include <set>

namespace varimarch
{

namespace
{

// The limits of Frame/MaterialChoices.cxx.
void ChooseMaterial(ChosenNumbers& numbers, RenderSettings& settings)
{
  const bool isComposite = settings.blend == Blend::Composite;
  settings.componentCount = numbers.Flag() ? 1 : numbers.Integer(2, 4);
  if (settings.componentCount > 1)
  {
    const bool isDependent = settings.componentCount != 3 && numbers.Flag();
    settings.components = !isDependent ? Components::Independent
      : settings.componentCount == 2   ? Components::LuminanceOpacity
                                       : Components::Rgba;
  }
  const bool isOne = settings.components == Components::One;
  if (isComposite && isOne)
  {
    settings.functionOf =
      numbers.Of({ FunctionOf::Value, FunctionOf::ValueAndGradient, FunctionOf::TwoValues });
  }
  const bool mayHaveLabels = isComposite && isOne && settings.functionOf != FunctionOf::TwoValues;
  settings.mask = numbers.Of({ Mask::None, Mask::Binary, Mask::Labels });
  if (settings.mask == Mask::Labels && !mayHaveLabels)
  {
    settings.mask = Mask::None;
  }
  const bool mayHaveGradientOpacity =
    settings.functionOf == FunctionOf::Value || settings.mask == Mask::Labels;
  settings.gradientOpacity = isComposite && mayHaveGradientOpacity && numbers.Flag();
}

// AccelerationOf in Frame/FrameBuilder.cxx.
Acceleration ChosenAcceleration(ChosenNumbers& numbers, const RenderSettings& settings)
{
  const bool isOne = settings.components == Components::One;
  const bool sums = IsProjection(settings.blend) && !settings.nearest;
  const bool mayUseValues = isOne && IsSampled(settings) && !settings.uneven;
  switch (numbers.Integer(0, 3))
  {
    case 0:
      return mayUseValues ? Acceleration::CellField : Acceleration::Off;
    case 1:
      return mayUseValues && !settings.cubic ? Acceleration::VariationField : Acceleration::Off;
    case 2:
      return settings.blend == Blend::Composite || settings.blend == Blend::Isosurface ||
          (isOne && (IsExtreme(settings.blend) || sums))
        ? Acceleration::OpticalField
        : Acceleration::Off;
    default:
      return Acceleration::Off;
  }
}

// The limits of Frame/FrameBuilder.cxx and Resources/VolumeResources.cxx.
void ChooseImage(ChosenNumbers& numbers, RenderSettings& settings)
{
  const bool isOne = settings.components == Components::One;
  settings.shading = !IsProjection(settings.blend) && numbers.Flag();
  settings.lights = settings.shading && numbers.Flag();
  settings.shadows = settings.lights && settings.blend == Blend::Composite && numbers.Flag();
  settings.softLights = settings.shadows && numbers.Flag();
  settings.casters = settings.shadows && numbers.Flag();
  settings.damping = settings.shading && isOne && numbers.Flag();
  settings.countFetches = numbers.Integer(0, 7) == 0;
  settings.sceneGeometry = numbers.Flag();
  settings.integration = numbers.Of({ Integration::Midpoint, Integration::PreIntegrated,
    Integration::Simpson, Integration::PublishedSum, Integration::FirstHit });
  settings.limitsSpan = numbers.Flag();
  settings.clipping = numbers.Flag();
  settings.cropping = numbers.Flag();
  settings.clippedGradients = settings.clipping && isOne && numbers.Flag();
  settings.gaps = numbers.Flag();
  settings.fillGaps = numbers.Flag();
  settings.skipsBricks = numbers.Flag();
  settings.windowLevel = numbers.Flag();
  settings.triesRays = numbers.Flag();
  settings.jitter = IsSampled(settings) && numbers.Flag();
  settings.pass =
    numbers.Of({ RayPass::Whole, RayPass::Upscaled, RayPass::Averaged, RayPass::Accumulated,
      RayPass::PeelOutside, RayPass::PeelBetween, RayPass::PeelLast, RayPass::PickProp,
      RayPass::PickVoxel, RayPass::PictureAndDepth, RayPass::Block, RayPass::Picture });
  const bool isInBlocks = settings.pass == RayPass::Block || settings.pass == RayPass::Picture;
  const bool mayBeInBlocks = !settings.uneven && !settings.countFetches &&
    (isOne || settings.blend != Blend::AverageIntensity);
  settings.pass = isInBlocks && !mayBeInBlocks ? RayPass::Whole : settings.pass;
}

RenderSettings ChosenSettings(ChosenNumbers& numbers)
{
  RenderSettings settings;
  settings.blend = numbers.Of(
    { Blend::Composite, Blend::Composite, Blend::MaximumIntensity, Blend::MinimumIntensity,
      Blend::AverageIntensity, Blend::Additive, Blend::Isosurface, Blend::Slice });
  const bool isSurface = settings.blend == Blend::Isosurface;
  settings.nearest = numbers.Flag();
  settings.cubic = !settings.nearest && !isSurface && numbers.Flag();
  ChooseMaterial(numbers, settings);
  settings.uneven =
    !settings.cubic && !isSurface && settings.mask == Mask::None && numbers.Integer(0, 3) == 0;
  settings.acceleration = ChosenAcceleration(numbers, settings);
  ChooseImage(numbers, settings);
  settings.storedGradients = settings.components == Components::One && numbers.Flag();
  if (settings.blend == Blend::Composite && !settings.nearest && numbers.Integer(0, 7) == 0)
  {
    settings.fromBehind = true;
    settings.acceleration = Acceleration::Off;
    settings.integration = Integration::Midpoint;
  }
  const bool isMean = settings.blend == Blend::AverageIntensity &&
    settings.components == Components::One && settings.acceleration == Acceleration::Off;
  settings.limitsMean =
    isMean && !settings.nearest && !settings.cubic && !settings.uneven && numbers.Flag();
  return settings;
}

/// Composites that overlap others: the limits of Frame/OverlappingVolumes.cxx.
RenderSettings Overlapping(RenderSettings settings)
{
  settings.blend = Blend::Composite;
  settings.mask = Mask::None;
  settings.cropping = settings.clippedGradients = settings.countFetches = settings.gaps = false;
  settings.overlaps = true;
  settings.pass = settings.pass == RayPass::PickVoxel ? RayPass::Whole : settings.pass;
  return settings;
}

/// Volumes that overlap take light from each other.
void ShareLight(RenderSettings& first)
{
  first.shadowsOthers = first.shadows ||
    std::any_of(first.others.begin(), first.others.end(),
      [](const RenderSettings& other) { return other.shadows; });
  for (RenderSettings& other : first.others)
  {
    other.shadowsOthers = first.shadowsOthers;
  }
}

void RequireCompiled(const std::vector<ShaderFile>& files, const std::string& stage)
{
  static std::set<std::string> compiled;
  if (!compiled.insert(AssembleShader(files)).second)
  {
    return;
  }
  const ShaderValidation validation = Validate({ files, stage });
  Require(validation.passed, "a shader does not compile: " + validation.messages);
}

bool RunRecipe(const std::string& input)
{
  ChosenNumbers numbers(input);
  RenderSettings settings = ChosenSettings(numbers);
  if (settings.blend == Blend::Composite && numbers.Integer(0, 3) == 0)
  {
    settings = Overlapping(settings);
    for (int other = numbers.Integer(1, 3); other > 0; --other)
    {
      settings.others.push_back(Overlapping(ChosenSettings(numbers)));
      settings.others.back().clipping = settings.others.back().jitter = false;
    }
    ShareLight(settings);
  }
  std::vector<ShaderFile> vertex = LoadParts(VertexShaderParts());
  std::vector<ShaderFile> fragment = LoadParts(FragmentShaderParts(settings));
  RequireCompiled(fragment, "frag");
  constexpr int MostFlatComponents = 124; // the limit of llvmpipe
  HandParametersOn(vertex, fragment, MostFlatComponents);
  RequireCompiled(vertex, "vert");
  RequireCompiled(fragment, "frag");
  return true;
}

}

FuzzTarget RecipeTarget()
{
  return { "recipes", RunRecipe, [] { return RandomInputs(16, 100); }, {} };
}

}
