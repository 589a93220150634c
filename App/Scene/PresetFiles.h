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

/// The files of Data/Presets; the build writes this table.
const std::vector<PresetFile>& PresetFiles();

}

#endif
