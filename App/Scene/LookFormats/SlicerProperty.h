#ifndef Varimarch_Scene_SlicerProperty_h
#define Varimarch_Scene_SlicerProperty_h

#include "Scene/LookFormats/LookContext.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace varimarch
{

/// 3D Slicer's volume property files. Those that read throw std::runtime_error that says in one
/// sentence what is wrong; `file` names the text in it, and the look. Looks to write are in units
/// of the data.

/// *.vp: nine lines of numbers, without midpoints, sharpness, blending and unit distance.
Look LookFromSlicerText(
  const std::string& text, const std::string& file, const LookContext& context);
std::string SlicerText(const Look& look, const LookContext& context);

/// *.vp.json, of which the first property and its first component count. It does not know blending.
Look LookFromSlicerJson(
  const nlohmann::json& json, const std::string& file, const LookContext& context);
std::string SlicerJson(const Look& look, const LookContext& context);

}

#endif
