#ifndef Varimarch_Scene_ChannelsJson_h
#define Varimarch_Scene_ChannelsJson_h

#include "Scene/JsonCursor.h"
#include "Scene/Scene.h"

#include <vector>

namespace varimarch
{

std::vector<LookChannel> ChannelsFromJson(const JsonCursor& json);

nlohmann::ordered_json JsonFromChannels(const std::vector<LookChannel>& channels);

}

#endif
