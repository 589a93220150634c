#ifndef Varimarch_Core_Recipe_ShaderRecipe_h
#define Varimarch_Core_Recipe_ShaderRecipe_h

#include "Core/Recipe/RenderSettings.h"

#include <string>
#include <vector>

namespace varimarch
{

/// The files of a fragment shader, in the order in which they are joined: paths below
/// VolumeModule/Shaders. One file per slot, and nothing that the settings do not ask for.
std::vector<std::string> FragmentShaderParts(const RenderSettings& settings);

/// Whether the recipe looks materials up in a PreIntegratedTable.
bool UsesPreIntegration(const RenderSettings& settings);

/// Whether the recipe marches a material: what depends on more than one scalar.
bool MarchesMaterial(const RenderSettings& settings);

/// How many materials the recipe mixes.
int PartCount(const RenderSettings& settings);

/// Whether the recipe looks at gradients.
bool UsesGradients(const RenderSettings& settings);

/// Whether the recipe draws cells that touch a voxel that is not finite.
bool FillsGaps(const RenderSettings& settings);

}

#endif
