#ifndef Varimarch_Scene_MeasuresJson_h
#define Varimarch_Scene_MeasuresJson_h

#include "Scene/JsonCursor.h"
#include "Scene/Scene.h"

namespace varimarch
{

/// The measurements of a scene, under the key "measures". Older files have "distances", "angles"
/// and "boxes" instead, which come first.
std::vector<Measure> MeasuresFromJson(const JsonCursor& scene);

nlohmann::ordered_json JsonFromMeasures(const std::vector<Measure>& measures);

}

#endif
