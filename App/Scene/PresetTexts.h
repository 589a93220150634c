#ifndef Varimarch_Scene_PresetTexts_h
#define Varimarch_Scene_PresetTexts_h

#include <vector>

namespace varimarch
{

struct PresetText
{
  const char* name;
  const char* json;
};

/// The files of Data/Presets; the build writes this table.
const std::vector<PresetText>& PresetTexts();

}

#endif
