#ifndef Varimarch_Scene_RenderJson_h
#define Varimarch_Scene_RenderJson_h

#include "Scene/JsonCursor.h"
#include "Scene/Scene.h"

namespace varimarch
{

/// Reads the options that the object has, and keeps the others.
void ReadRender(const JsonCursor& json, RenderOptions& render);

nlohmann::ordered_json JsonFromRender(const RenderOptions& render);

}

#endif
