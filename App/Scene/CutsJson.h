#ifndef Varimarch_Scene_CutsJson_h
#define Varimarch_Scene_CutsJson_h

#include "Scene/JsonCursor.h"
#include "Scene/Scene.h"

namespace varimarch
{

SceneCuts CutsFromJson(const JsonCursor& json);

nlohmann::ordered_json JsonFromCuts(const SceneCuts& cuts);

}

#endif
