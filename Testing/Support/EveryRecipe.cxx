#include "Support/EveryRecipe.h"

#include "Core/Recipe/MaterialRecipe.h"
#include "Support/LightRecipes.h"
#include "Support/RecipesOfVolumes.h"

#include <utility>

namespace varimarch
{

namespace
{

constexpr Acceleration EveryAcceleration[] = { Acceleration::Off, Acceleration::CellField,
  Acceleration::VariationField, Acceleration::OpticalField };

std::vector<RenderSettings> RecipesOfRays()
{
  std::vector<RenderSettings> recipes;
  for (Acceleration acceleration : EveryAcceleration)
  {
    for (const bool sceneGeometry : { false, true })
    {
      recipes.push_back({ Blend::Composite, acceleration, false, sceneGeometry });
      recipes.back().limitsSpan = true;
      recipes.back().triesRays = true;
      recipes.back().jitter = true;
      recipes.back().windowLevel = true;
    }
  }
  return recipes;
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
  const std::vector<RenderSettings> ofRays = RecipesOfRays();
  recipes.insert(recipes.end(), ofRays.begin(), ofRays.end());
  recipes.emplace_back();
  recipes.back().pass = RayPass::Accumulated;
  for (bool windowLevel : { false, true })
  {
    recipes.emplace_back();
    recipes.back().role = ShaderRole::ShowMarchedImage;
    recipes.back().windowLevel = windowLevel;
  }
  recipes.emplace_back();
  recipes.back().role = ShaderRole::DimGeometry;
  for (RayPass pass : { RayPass::PeelOutside, RayPass::PeelBetween, RayPass::PeelLast,
         RayPass::PickProp, RayPass::PickVoxel, RayPass::PictureAndDepth })
  {
    recipes.push_back({});
    recipes.back().pass = pass;
    recipes.push_back(recipes.back());
    recipes.back().role = ShaderRole::ShowMarchedImage;
    if (Peels(pass))
    {
      recipes.push_back(recipes.back());
      recipes.back().role = ShaderRole::WriteLayerDepths;
    }
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

std::vector<RenderSettings> RecipesOfGrowingSteps()
{
  std::vector<RenderSettings> recipes;
  for (bool shading : { false, true })
  {
    recipes.push_back({ Blend::Composite, Acceleration::OpticalField, shading, false });
    recipes.back().skipsBricks = false;
  }
  return recipes;
}

std::vector<RenderSettings> RecipesFromBehind()
{
  std::vector<RenderSettings> recipes;
  for (bool shading : { false, true })
  {
    for (RayPass pass : { RayPass::Whole, RayPass::Block, RayPass::PickVoxel })
    {
      recipes.push_back({ Blend::Composite, Acceleration::Off, shading, false });
      recipes.back().fromBehind = true;
      recipes.back().jitter = shading;
      recipes.back().pass = pass;
    }
  }
  return recipes;
}

std::vector<RenderSettings> RecipesWithStoredGradients()
{
  RenderSettings lit;
  lit.shading = true;
  lit.storedGradients = true;
  RenderSettings two = lit;
  two.functionOf = FunctionOf::ValueAndGradient;
  RenderSettings surfaces{ Blend::Isosurface, Acceleration::OpticalField, true };
  surfaces.storedGradients = true;
  RenderSettings counted = lit;
  counted.gaps = true;
  counted.countFetches = true;
  RenderSettings joined = lit;
  joined.overlaps = true;
  joined.others = { joined };
  return { lit, two, surfaces, counted, joined };
}

// The recipes on devices that round the weights of their filters.
std::vector<RenderSettings> RecipesFilteredByTexels()
{
  RenderSettings plain;
  plain.filter = Filter::OfTexels;
  RenderSettings spline = plain;
  spline.cubic = true;
  spline.shading = true;
  RenderSettings stored = plain;
  stored.shading = true;
  stored.storedGradients = true;
  RenderSettings steep = plain;
  steep.gradientOpacity = true;
  RenderSettings joined = plain;
  joined.overlaps = true;
  joined.others = { joined };
  return { plain, spline, stored, steep, joined };
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

std::vector<RenderSettings> RecipesOfRangeMeans()
{
  std::vector<RenderSettings> recipes;
  for (RayPass pass : { RayPass::Whole, RayPass::Block, RayPass::PickVoxel })
  {
    recipes.push_back({ Blend::AverageIntensity, Acceleration::Off });
    recipes.back().limitsMean = true;
    recipes.back().pass = pass;
  }
  return recipes;
}

std::vector<RenderSettings> RecipesOfFunctionsAndMasks()
{
  RenderSettings binary;
  binary.mask = Mask::Binary;
  RenderSettings maximum{ Blend::MaximumIntensity, Acceleration::Off };
  maximum.mask = Mask::Binary;
  std::vector<RenderSettings> recipes = { binary, maximum };
  for (const bool shading : { false, true })
  {
    RenderSettings labels;
    labels.shading = shading;
    labels.mask = Mask::Labels;
    labels.labelSurfaces = shading;
    recipes.push_back(labels);
    labels.gradientOpacity = true;
    labels.labelSurfaces = false;
    recipes.push_back(labels);
    labels.functionOf = FunctionOf::ValueAndGradient;
    recipes.push_back(labels);
    for (FunctionOf functionOf : { FunctionOf::ValueAndGradient, FunctionOf::TwoValues })
    {
      RenderSettings two;
      two.shading = shading;
      two.functionOf = functionOf;
      recipes.push_back(two);
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
  RenderSettings damped;
  damped.shading = true;
  damped.damping = true;
  RenderSettings shadowed = lit;
  shadowed.shadows = true;
  std::vector<RenderSettings> recipes = { lit, damped, gradient, litGradient, shadowed };
  const std::vector<RenderSettings> others = RecipesOfFunctionsAndMasks();
  recipes.insert(recipes.end(), others.begin(), others.end());
  for (const auto& [components, count] : { std::pair(Components::Independent, 3),
         std::pair(Components::LuminanceOpacity, 2), std::pair(Components::Rgba, 4) })
  {
    for (RenderSettings settings : { RenderSettings(), lit, litGradient, shadowed })
    {
      settings.components = components;
      settings.componentCount = count;
      recipes.push_back(settings);
    }
    for (Blend blend : { Blend::MaximumIntensity, Blend::AverageIntensity, Blend::Additive })
    {
      RenderSettings projection{ blend, Acceleration::Off };
      projection.components = components;
      projection.componentCount = count;
      recipes.push_back(projection);
    }
  }
  return recipes;
}

std::vector<RenderSettings> RecipesOfLinearMaterials()
{
  std::vector<RenderSettings> recipes;
  for (RenderSettings recipe : RecipesOfMaterials())
  {
    if (MarchesMaterial(recipe))
    {
      recipe.integration = Integration::PreIntegrated;
      recipes.push_back(recipe);
    }
  }
  return recipes;
}

std::vector<RenderSettings> RecipesOfSplines()
{
  RenderSettings cubic;
  cubic.cubic = true;
  RenderSettings lit = cubic;
  lit.shading = true;
  RenderSettings components = lit;
  components.components = Components::Independent;
  components.componentCount = 2;
  RenderSettings maximum{ Blend::MaximumIntensity };
  maximum.cubic = true;
  return { cubic, lit, components, maximum };
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
  RenderSettings lit = recipes.front();
  lit.shading = true;
  lit.clippedGradients = true;
  recipes.push_back(lit);
  RenderSettings inBlocks = recipes[2];
  inBlocks.pass = RayPass::Block;
  recipes.push_back(inBlocks);
  inBlocks.pass = RayPass::Picture;
  recipes.push_back(inBlocks);
  return recipes;
}

std::vector<RenderSettings> ExactRecipes()
{
  std::vector<RenderSettings> recipes;
  const auto add = [&](Blend blend, bool nearest, bool shading)
  {
    recipes.push_back({ blend, Acceleration::Off, shading });
    recipes.back().nearest = nearest;
  };
  for (Blend blend :
    { Blend::MaximumIntensity, Blend::MinimumIntensity, Blend::AverageIntensity, Blend::Additive })
  {
    for (RayPass pass : { RayPass::Whole, RayPass::PickVoxel })
    {
      add(blend, true, false);
      recipes.back().pass = pass;
    }
  }
  for (bool shading : { false, true })
  {
    add(Blend::Composite, true, shading);
    add(Blend::Isosurface, true, shading);
    add(Blend::Isosurface, false, shading);
    add(Blend::Slice, false, shading);
  }
  recipes.push_back({ Blend::Isosurface, Acceleration::OpticalField });
  for (bool shading : { false, true })
  {
    recipes.push_back({ Blend::Composite, Acceleration::Off, shading });
    recipes.back().uneven = true;
  }
  return recipes;
}

}

std::vector<RenderSettings> EveryRecipe()
{
  RenderSettings counting;
  counting.countFetches = true;
  std::vector<RenderSettings> recipes = { counting };
  for (const std::vector<RenderSettings>& others :
    { RecipesOfMaterials(), RecipesOfLinearMaterials(), RecipesOfGrowingSteps(), RecipesWithGaps(),
      RecipesInBlocks(), RecipesOfPictures(), RecipesOfShadows(), RecipesOfOcclusion(),
      RecipesOfSplines(), RecipesWithCuts(), RecipesOfSeveralVolumes(), RecipesOfVolumesInLight(),
      RecipesFromBehind(), RecipesWithStoredGradients(), RecipesFilteredByTexels(),
      RecipesOfRangeMeans(), ExactRecipes() })
  {
    recipes.insert(recipes.end(), others.begin(), others.end());
  }
  for (Acceleration acceleration : EveryAcceleration)
  {
    for (bool sceneGeometry : { false, true })
    {
      for (Integration integration : { Integration::Midpoint, Integration::PreIntegrated,
             Integration::Simpson, Integration::PublishedSum, Integration::FirstHit })
      {
        recipes.push_back({ Blend::Composite, acceleration, false, sceneGeometry, integration });
      }
      for (Integration integration : { Integration::Midpoint, Integration::PreIntegrated })
      {
        recipes.push_back({ Blend::Composite, acceleration, true, sceneGeometry, integration });
      }
      for (Blend blend : { Blend::MaximumIntensity, Blend::MinimumIntensity,
             Blend::AverageIntensity, Blend::Additive })
      {
        recipes.push_back({ blend, acceleration, false, sceneGeometry });
      }
    }
  }
  return recipes;
}

}
