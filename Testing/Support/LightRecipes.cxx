#include "Support/LightRecipes.h"

namespace varimarch
{

std::vector<RenderSettings> RecipesOfShadows()
{
  RenderSettings plain;
  plain.shading = true;
  plain.lights = true;
  plain.shadows = true;
  std::vector<RenderSettings> recipes(12, plain);
  recipes[0].acceleration = Acceleration::Off;
  recipes[1].skipsBricks = false;
  recipes[2].nearest = true;
  recipes[3].cubic = true;
  recipes[4].clipping = true;
  recipes[4].cropping = true;
  recipes[4].gaps = true;
  recipes[5].mask = Mask::Labels;
  recipes[5].gradientOpacity = true;
  recipes[6].functionOf = FunctionOf::TwoValues;
  recipes[7].scattering = true;
  recipes[8].softLights = true;
  recipes[9].scattering = true;
  recipes[9].shadows = false;
  recipes[9].damping = true;
  recipes[10].casters = true;
  recipes[11].casters = true;
  recipes[11].softLights = true;
  for (std::size_t i = 0; i < 9; ++i)
  {
    recipes.push_back(recipes[i]);
    recipes.back().role = ShaderRole::LightPlaces;
  }
  return recipes;
}

std::vector<RenderSettings> RecipesOfOcclusion()
{
  RenderSettings plain;
  plain.occlusion = true;
  std::vector<RenderSettings> recipes(12, plain);
  recipes[0].integration = Integration::PreIntegrated;
  recipes[1].shading = true;
  recipes[1].lights = true;
  recipes[1].shadows = true;
  recipes[1].softLights = true;
  recipes[2].nearest = true;
  recipes[2].acceleration = Acceleration::Off;
  recipes[3].mask = Mask::Labels;
  recipes[3].labelSurfaces = true;
  recipes[4].mask = Mask::Labels;
  recipes[4].functionOf = FunctionOf::ValueAndGradient;
  recipes[4].gradientOpacity = true;
  recipes[5].functionOf = FunctionOf::TwoValues;
  recipes[6].functionOf = FunctionOf::ValueAndGradient;
  recipes[6].cubic = true;
  recipes[7].fromBehind = true;
  recipes[7].acceleration = Acceleration::Off;
  recipes[8].clipping = true;
  recipes[8].clippedGradients = true;
  recipes[8].cropping = true;
  recipes[8].gaps = true;
  recipes[8].pass = RayPass::PictureAndDepth;
  recipes[9].components = Components::Independent;
  recipes[9].componentCount = 3;
  recipes[9].integration = Integration::PreIntegrated;
  recipes[10].components = Components::LuminanceOpacity;
  recipes[10].componentCount = 2;
  recipes[10].nearest = true;
  recipes[11].components = Components::Rgba;
  recipes[11].componentCount = 4;
  recipes[11].gradientOpacity = true;
  return recipes;
}

}
