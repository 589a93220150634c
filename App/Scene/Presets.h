#ifndef Varimarch_Scene_Presets_h
#define Varimarch_Scene_Presets_h

#include "Scene/Scene.h"

#include <string>
#include <vector>

namespace varimarch
{

/// The looks that come with the program: the files of Data/Presets, built in, so that nothing has
/// to be found at run time.
std::vector<std::string> PresetNames();

bool IsPresetName(const std::string& name);

/// @throws std::invalid_argument for a name that is none of PresetNames()
Look Preset(const std::string& name);

}

#endif
