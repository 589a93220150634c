#ifndef Varimarch_Scene_MeasuresJson_h
#define Varimarch_Scene_MeasuresJson_h

#include "Scene/JsonCursor.h"
#include "Scene/Scene.h"

namespace varimarch
{

// Each kind has its own key in a scene; a missing key means no measurements.

std::vector<Distance> DistancesFromJson(const JsonCursor& scene);
std::vector<Angle> AnglesFromJson(const JsonCursor& scene);
std::vector<MeasuredBox> BoxesFromJson(const JsonCursor& scene);

nlohmann::ordered_json JsonFromDistances(const std::vector<Distance>& distances);
nlohmann::ordered_json JsonFromAngles(const std::vector<Angle>& angles);
nlohmann::ordered_json JsonFromBoxes(const std::vector<MeasuredBox>& boxes);

}

#endif
