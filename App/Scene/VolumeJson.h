#ifndef Varimarch_Scene_VolumeJson_h
#define Varimarch_Scene_VolumeJson_h

#include "Scene/JsonCursor.h"
#include "Scene/Scene.h"

namespace varimarch
{

/// A volume from an object that names a file or what is to be computed.
VolumeSource VolumeFromJson(const JsonCursor& json);

nlohmann::ordered_json JsonFromVolume(const VolumeSource& volume);

}

#endif
