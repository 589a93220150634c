#ifndef Varimarch_Scene_ShadingPresets_h
#define Varimarch_Scene_ShadingPresets_h

#include "Scene/SceneNames.h"

#include <optional>
#include <string>

namespace varimarch
{

/// Named shadings, from the softest to the hardest.
const NameTable<Shading>& ShadingPresets();

/// Name of a shading; empty if it equals none of the named ones.
std::optional<std::string> NameOfShading(const Shading& shading);

}

#endif
