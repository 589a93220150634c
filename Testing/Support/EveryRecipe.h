#ifndef Varimarch_Testing_Support_EveryRecipe_h
#define Varimarch_Testing_Support_EveryRecipe_h

#include "Core/Recipe/RenderSettings.h"

#include <vector>

namespace varimarch
{

/// Every combination of settings that makes a different shader.
std::vector<RenderSettings> EveryRecipe();

}

#endif
