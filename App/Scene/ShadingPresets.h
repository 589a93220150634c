#ifndef Varimarch_Scene_ShadingPresets_h
#define Varimarch_Scene_ShadingPresets_h

#include "Scene/SceneNames.h"

#include <optional>
#include <string>

namespace varimarch
{

/// Kinds of light by name, the softest first.
const NameTable<Shading>& ShadingPresets();

/// The name of the kind that a shading is; none: it is one of its own.
std::optional<std::string> NameOfShading(const Shading& shading);

}

#endif
