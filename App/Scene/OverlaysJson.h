#ifndef Varimarch_Scene_OverlaysJson_h
#define Varimarch_Scene_OverlaysJson_h

#include "Scene/JsonCursor.h"
#include "Scene/Scene.h"

namespace varimarch
{

std::vector<OverlaidVolume> OverlaysFromJson(const JsonCursor& json);

nlohmann::ordered_json JsonFromOverlays(const std::vector<OverlaidVolume>& overlays);

}

#endif
