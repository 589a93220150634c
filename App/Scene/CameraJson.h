#ifndef Varimarch_Scene_CameraJson_h
#define Varimarch_Scene_CameraJson_h

#include "Scene/JsonCursor.h"
#include "Scene/Scene.h"

namespace varimarch
{

Camera CameraFromJson(const JsonCursor& json);

nlohmann::ordered_json JsonFromCamera(const Camera& camera);

}

#endif
