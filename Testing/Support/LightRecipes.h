#ifndef Varimarch_Testing_Support_LightRecipes_h
#define Varimarch_Testing_Support_LightRecipes_h

#include "Core/Recipe/RenderSettings.h"

#include <vector>

namespace varimarch
{

// Combinations of settings for light that matter takes, which EveryRecipe() contains.

std::vector<RenderSettings> RecipesOfShadows();
std::vector<RenderSettings> RecipesOfOcclusion();

}

#endif
