#ifndef Varimarch_Testing_Support_EveryRecipe_h
#define Varimarch_Testing_Support_EveryRecipe_h

#include "Core/Recipe/RenderSettings.h"

#include <vector>

namespace varimarch
{

/// All combinations of settings that result in different shaders.
std::vector<RenderSettings> EveryRecipe();

}

#endif
