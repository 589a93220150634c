#ifndef Varimarch_Scene_PresetFiles_h
#define Varimarch_Scene_PresetFiles_h

#include <vector>

namespace varimarch
{

struct PresetFile
{
  const char* name;
  const char* json;
};

/// Contents of the files in Data/Presets. The build generates this table.
const std::vector<PresetFile>& PresetFiles();

}

#endif
