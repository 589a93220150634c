#ifndef Varimarch_Scene_KeyImagesJson_h
#define Varimarch_Scene_KeyImagesJson_h

#include "Scene/JsonCursor.h"
#include "Scene/Scene.h"

namespace varimarch
{

/// The key "keyImages" of a scene; none without it.
std::vector<KeyImage> KeyImagesFromJson(const JsonCursor& scene);

nlohmann::ordered_json JsonFromKeyImages(const std::vector<KeyImage>& images);

}

#endif
