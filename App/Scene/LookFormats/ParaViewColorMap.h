#ifndef Varimarch_Scene_ParaViewColorMap_h
#define Varimarch_Scene_ParaViewColorMap_h

#include "Scene/LookFormats/LookContext.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace varimarch
{

/// ParaView's colour maps, *.json: colours, and opacities or none. Of several the first counts.

/// Whether a JSON value may be one.
bool IsParaViewColorMap(const nlohmann::json& json);

/// What is on the scale from 0 to 1, as the maps that come with ParaView are, is spread over the
/// volume's values; where the file holds colours alone, over those of the opacities that stay.
/// @throws std::runtime_error one sentence; `file` names the text in it, and the look
Look LookFromParaViewJson(
  const nlohmann::json& json, const std::string& file, const LookContext& context);

/// @param look  in units of the data; light, blending and gradient opacity are not written
std::string ParaViewJson(const Look& look);

}

#endif
