#ifndef Varimarch_Scene_VolumeJson_h
#define Varimarch_Scene_VolumeJson_h

#include "Scene/JsonCursor.h"
#include "Scene/Scene.h"

namespace varimarch
{

/// Reads a volume from a JSON object that names a file or a procedural volume.
VolumeSource VolumeFromJson(const JsonCursor& json);

nlohmann::ordered_json JsonFromVolume(const VolumeSource& volume);

}

#endif
