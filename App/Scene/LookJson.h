#ifndef Varimarch_Scene_LookJson_h
#define Varimarch_Scene_LookJson_h

#include "Scene/JsonCursor.h"
#include "Scene/Scene.h"

namespace varimarch
{

/// A look from an object, or the preset that a text names.
Look LookFromJson(const JsonCursor& json);

nlohmann::ordered_json JsonFromLook(const Look& look);

}

#endif
