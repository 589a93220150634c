#ifndef Varimarch_Core_Recipe_MaterialRecipe_h
#define Varimarch_Core_Recipe_MaterialRecipe_h

#include "Core/Recipe/RenderSettings.h"

#include <string>
#include <vector>

namespace varimarch
{

/// Files of a shader that determine what a point of the volume looks like.

/// True if the shader marches a material, which depends on more than one scalar.
bool MarchesMaterial(const RenderSettings& settings);

/// Files that turn scalars into colour and extinction.
std::vector<std::string> ClassifyParts(const RenderSettings& settings);

/// Files that depend on more than one scalar: gradients, light, and the material made from them.
std::vector<std::string> MaterialParts(const RenderSettings& settings);

std::string ShadeFile(const RenderSettings& settings);
/// The files of the slots Reach, Cone and Scatter, for a shading that takes all lights.
std::vector<std::string> LightParts(const RenderSettings& settings);
/// The files of the slots Sky and Outside, and those that they share.
std::vector<std::string> SkyParts(const RenderSettings& settings);
std::string GradientFile(const RenderSettings& settings);

}

#endif
