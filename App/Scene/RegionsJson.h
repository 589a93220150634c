#ifndef Varimarch_Scene_RegionsJson_h
#define Varimarch_Scene_RegionsJson_h

#include "Scene/JsonCursor.h"
#include "Scene/Scene.h"

#include <string>
#include <vector>

namespace varimarch
{

/// The largest number of regions in a look.
constexpr std::size_t MostRegions = 64;

std::vector<LookRegion> RegionsFromJson(const JsonCursor& json);

/// Reads a file that holds an array of regions. @throws std::runtime_error that names the file
std::vector<LookRegion> ReadRegions(const std::string& path);

nlohmann::ordered_json JsonFromRegions(const std::vector<LookRegion>& regions);

}

#endif
