#ifndef Varimarch_Testing_RecipesOfVolumes_h
#define Varimarch_Testing_RecipesOfVolumes_h

#include "Core/Recipe/RenderSettings.h"

#include <vector>

namespace varimarch
{

/// Recipes of volumes that overlap.
std::vector<RenderSettings> RecipesOfSeveralVolumes();

/// The same with volumes that take light from each other.
std::vector<RenderSettings> RecipesOfVolumesInLight();

}

#endif
