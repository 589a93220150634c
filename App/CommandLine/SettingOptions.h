#ifndef Varimarch_CommandLine_SettingOptions_h
#define Varimarch_CommandLine_SettingOptions_h

#include "SceneArguments.h"

namespace CLI
{
class App;
}

namespace varimarch
{

// Options for the settings of a scene. They are made from the lists of fields in
// Scene/Json/SceneFields.h, so that a setting has one key, range and sentence.

/// Adds the options of lights, of how matter takes and scatters light, and of the blend mode.
void AddLookSettings(CLI::App& command, SceneArguments& arguments);

/// Adds the options of camera, cuts, size and background.
void AddImageSettings(CLI::App& command, SceneArguments& arguments);

/// Adds the options of quality and speed.
void AddSamplingSettings(CLI::App& command, SceneArguments& arguments);

}

#endif
