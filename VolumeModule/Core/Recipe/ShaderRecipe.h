#ifndef Varimarch_Core_Recipe_ShaderRecipe_h
#define Varimarch_Core_Recipe_ShaderRecipe_h

#include "Core/Recipe/RenderSettings.h"

#include <string>
#include <vector>

namespace varimarch
{

/// The files of a fragment shader, as paths below VolumeModule/Shaders in the order in which they
/// are joined: one per slot, and only those that the settings need. Files that these include, the
/// formulas of Shaders/Math, are not among them.
std::vector<std::string> FragmentShaderParts(const RenderSettings& settings);

/// True if the shader uses a PreIntegratedTable.
bool UsesPreIntegration(const RenderSettings& settings);

/// True if the march of a frame reads gradients from a texture.
bool ReadsStoredGradients(const RenderSettings& settings);

/// Number of materials that the shader mixes.
int PartCount(const RenderSettings& settings);

/// True if the shader draws cells that touch a non-finite voxel.
bool FillsGaps(const RenderSettings& settings);

}

#endif
