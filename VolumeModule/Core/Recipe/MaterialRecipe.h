#ifndef Varimarch_Core_Recipe_MaterialRecipe_h
#define Varimarch_Core_Recipe_MaterialRecipe_h

#include "Core/Recipe/RenderSettings.h"

#include <string>
#include <vector>

namespace varimarch
{

/// The part of a shader's recipe that says what a point of the volume looks like.

/// What makes colours and extinctions of scalars.
std::vector<std::string> ClassifyParts(const RenderSettings& settings);

/// What depends on more than one scalar: gradients, light, and the material of them.
std::vector<std::string> MaterialParts(const RenderSettings& settings);

std::string ShadeFile(const RenderSettings& settings);
std::string GradientFile(const RenderSettings& settings);

}

#endif
