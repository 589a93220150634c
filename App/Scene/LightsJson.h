#ifndef Varimarch_Scene_LightsJson_h
#define Varimarch_Scene_LightsJson_h

#include "Scene/JsonCursor.h"
#include "Scene/Scene.h"

#include <vector>

namespace varimarch
{

/// The largest number of lights in a scene, for which VTK's GPU mapper has room too.
constexpr std::size_t MostLights = 6;

std::vector<SceneLight> LightsFromJson(const JsonCursor& json);

nlohmann::ordered_json JsonFromLights(const std::vector<SceneLight>& lights);

}

#endif
