#include "Scene/Presets.h"

#include "PresetTexts.h"
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
  for (const PresetText& preset : PresetTexts())
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

Look Preset(const std::string& name)
{
  for (const PresetText& preset : PresetTexts())
  {
    if (name == preset.name)
    {
      return LookFromText(preset.json, "preset " + name);
    }
  }
  throw std::invalid_argument(
    "unknown preset \"" + name + "\"; " + Suggestion(name, PresetNames()));
}

bool IsPreset(const Look& look, const ImageStatistics& statistics)
{
  return IsPresetName(look.name) &&
    LookText(InUnitsOfData(Preset(look.name), statistics)) == LookText(look);
}

}
