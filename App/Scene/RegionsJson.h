#ifndef Varimarch_Scene_RegionsJson_h
#define Varimarch_Scene_RegionsJson_h

#include "Scene/JsonCursor.h"
#include "Scene/Scene.h"

#include <vector>

namespace varimarch
{

/// The largest number of regions in a look.
constexpr std::size_t MostRegions = 64;

std::vector<LookRegion> RegionsFromJson(const JsonCursor& json);

nlohmann::ordered_json JsonFromRegions(const std::vector<LookRegion>& regions);

}

#endif
