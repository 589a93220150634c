#ifndef Varimarch_Scene_SlicesJson_h
#define Varimarch_Scene_SlicesJson_h

#include "Scene/JsonCursor.h"
#include "Scene/Scene.h"

namespace varimarch
{

SliceSettings SlicesFromJson(const JsonCursor& json);

nlohmann::ordered_json JsonFromSlices(const SliceSettings& slices);

}

#endif
