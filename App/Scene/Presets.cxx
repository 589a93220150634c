#include "Scene/Presets.h"

#include "PresetFiles.h"
#include "Scene/SceneFile.h"
#include "Scene/SceneNames.h"
#include "Scene/VolumeProperty.h"

#include <algorithm>
#include <stdexcept>

namespace varimarch
{

std::vector<std::string> PresetNames()
{
  std::vector<std::string> names;
  for (const PresetFile& preset : PresetFiles())
  {
    names.push_back(preset.name);
  }
  return names;
}

bool IsPresetName(const std::string& name)
{
  const std::vector<std::string> names = PresetNames();
  return std::find(names.begin(), names.end(), name) != names.end();
}

Preset BuiltInPreset(const std::string& name)
{
  for (const PresetFile& preset : PresetFiles())
  {
    if (name == preset.name)
    {
      return PresetFromText(preset.json, "preset " + name);
    }
  }
  throw std::invalid_argument(
    "unknown preset \"" + name + "\"; " + Suggestion(name, PresetNames()));
}

bool IsBuiltInLook(const Look& look, const ImageStatistics& statistics)
{
  return IsPresetName(look.name) &&
    LookText(InUnitsOfData(BuiltInPreset(look.name).look, statistics)) == LookText(look);
}

void TakePreset(const Preset& preset, Scene& scene)
{
  scene.look = preset.look;
  scene.render.errorTolerance = preset.errorTolerance.value_or(scene.render.errorTolerance);
  scene.background = preset.background.value_or(scene.background);
}

Preset PresetOf(const Scene& scene)
{
  return { scene.look, scene.render.errorTolerance, scene.background };
}

}
