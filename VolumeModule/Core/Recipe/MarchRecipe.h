#ifndef Varimarch_Core_Recipe_MarchRecipe_h
#define Varimarch_Core_Recipe_MarchRecipe_h

#include "Core/Recipe/RenderSettings.h"

#include <string>
#include <vector>

namespace varimarch
{

/// Files of a shader that march along a ray.

/// True if the volume is drawn as boxes, which rays cross from face to face.
bool IsOfBoxes(const RenderSettings& settings);

/// The file that finds the segments of a ray.
std::string StepFile(const RenderSettings& settings);

/// The file that integrates, and the loop and the functions that it calls.
std::vector<std::string> MarchParts(const RenderSettings& settings);

}

#endif
