#ifndef Varimarch_Core_PassRecipe_h
#define Varimarch_Core_PassRecipe_h

#include "Core/RenderSettings.h"

#include <string>
#include <vector>

namespace varimarch
{

/// The part of a shader's recipe that says what becomes of a ray.

std::string BlendFile(const RenderSettings& settings);
std::string ResumeFile(RayPass pass);
std::string WindowFile(const RenderSettings& settings);

/// Its files behind those that march a ray.
std::vector<std::string> PassParts(const RenderSettings& settings);

}

#endif
