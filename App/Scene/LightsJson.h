#ifndef Varimarch_Scene_LightsJson_h
#define Varimarch_Scene_LightsJson_h

#include "Scene/JsonCursor.h"
#include "Scene/Scene.h"

#include <vector>

namespace varimarch
{

/// The largest number of lights in a scene, for which VTK's GPU mapper has room too.
constexpr std::size_t MostLights = 6;

/// Reads the keys of light in an object that may have others, too.
Lighting LightingFromJson(const JsonCursor& json);

/// Adds these keys, but none for what is off.
void AddLighting(const Lighting& lighting, nlohmann::ordered_json& json);

/// The keys of light.
std::vector<std::string> LightingKeys();

}

#endif
