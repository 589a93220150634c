#ifndef Varimarch_Scene_Presets_h
#define Varimarch_Scene_Presets_h

#include "Scene/Scene.h"

#include <string>
#include <vector>

namespace varimarch
{

class ImageStatistics;

/// Names of the built-in presets. The files of Data/Presets are compiled in, so that none has to be
/// found at run time.
std::vector<std::string> PresetNames();

bool IsPresetName(const std::string& name);

/// @throws std::invalid_argument for a name that is not in PresetNames()
Preset BuiltInPreset(const std::string& name);

/// True if a look still equals the preset that it is named after, for a volume with these
/// statistics.
bool IsBuiltInLook(const Look& look, const ImageStatistics& statistics);

/// Applies a preset to a scene.
void TakePreset(const Preset& preset, Scene& scene);

/// The preset that gives other scenes the look of this one.
Preset PresetOf(const Scene& scene);

}

#endif
