#ifndef Varimarch_Scene_ParaViewColorMap_h
#define Varimarch_Scene_ParaViewColorMap_h

#include "Scene/LookFormats/LookContext.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace varimarch
{

/// ParaView's colour maps, *.json: colours with or without opacities. Only the first map of a file
/// is read.

/// True if a JSON value looks like a ParaView colour map.
bool IsParaViewColorMap(const nlohmann::json& json);

/// Reads a colour map. A map on [0, 1], as ParaView ships them, is spread over the range of the
/// volume's values or, if it has only colours, over that of the context's opacities.
/// @param file  name of the look, and of the text in errors
/// @throws std::runtime_error with one sentence
Look LookFromParaViewJson(
  const nlohmann::json& json, const std::string& file, const LookContext& context);

/// @param look  in units of the data; light, blend mode and gradient opacity are not written
std::string ParaViewJson(const Look& look);

}

#endif
