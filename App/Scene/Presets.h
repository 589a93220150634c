#ifndef Varimarch_Scene_Presets_h
#define Varimarch_Scene_Presets_h

#include "Scene/Scene.h"

#include <string>
#include <vector>

namespace varimarch
{

class ImageStatistics;

/// The presets that come with the program: the files of Data/Presets, built in, so that nothing has
/// to be found at run time.
std::vector<std::string> PresetNames();

bool IsPresetName(const std::string& name);

/// @throws std::invalid_argument for a name that is none of PresetNames()
Preset BuiltInPreset(const std::string& name);

/// Whether a look is still what the preset of its name is for a volume.
bool IsBuiltInLook(const Look& look, const ImageStatistics& statistics);

/// Gives a scene all that a preset holds.
void TakePreset(const Preset& preset, Scene& scene);

/// The preset that makes other scenes look like this one.
Preset PresetOf(const Scene& scene);

}

#endif
