#ifndef Varimarch_Scene_LookJson_h
#define Varimarch_Scene_LookJson_h

#include "Scene/JsonCursor.h"
#include "Scene/Scene.h"

namespace varimarch
{

/// Reads a preset from a JSON object, or the built-in preset that a JSON string names.
Preset PresetFromJson(const JsonCursor& json);

nlohmann::ordered_json JsonFromLook(const Look& look);
nlohmann::ordered_json JsonFromPreset(const Preset& preset);

}

#endif
