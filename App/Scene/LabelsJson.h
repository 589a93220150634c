#ifndef Varimarch_Scene_LabelsJson_h
#define Varimarch_Scene_LabelsJson_h

#include "Scene/JsonCursor.h"
#include "Scene/Scene.h"

namespace varimarch
{

SceneLabels LabelsFromJson(const JsonCursor& json);

/// Reads a list of segments, each value at most once.
std::vector<Segment> SegmentsFromJson(const JsonCursor& json);

nlohmann::ordered_json JsonFromLabels(const SceneLabels& labels);

}

#endif
