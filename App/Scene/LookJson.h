#ifndef Varimarch_Scene_LookJson_h
#define Varimarch_Scene_LookJson_h

#include "Scene/JsonCursor.h"
#include "Scene/Scene.h"

namespace varimarch
{

/// A preset from an object, or the one that a text names.
Preset PresetFromJson(const JsonCursor& json);

nlohmann::ordered_json JsonFromLook(const Look& look);
nlohmann::ordered_json JsonFromPreset(const Preset& preset);

}

#endif
