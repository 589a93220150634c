#ifndef Varimarch_Scene_SlicerProperty_h
#define Varimarch_Scene_SlicerProperty_h

#include "Scene/LookFormats/LookContext.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace varimarch
{

/// 3D Slicer's volume property files. The reading functions throw std::runtime_error with one
/// sentence; their `file` names the look, and the text in errors. The writing functions take looks
/// in units of the data.

/// The settings of a volume property as texts of numbers. Curves begin with the count of their
/// numbers.
struct SlicerNumbers
{
  std::string shade;
  std::string diffuse;
  std::string ambient;
  std::string specular;
  std::string specularPower;
  std::string scalarOpacity;   ///< value and opacity for each node
  std::string gradientOpacity; ///< gradient and opacity for each node
  std::string colors;          ///< value, red, green and blue for each node
};
Look LookFromSlicerNumbers(
  const SlicerNumbers& texts, const std::string& file, const LookContext& context);

/// *.vp: nine lines of numbers, without midpoints, sharpness, blend mode and unit distance.
Look LookFromSlicerText(
  const std::string& text, const std::string& file, const LookContext& context);
std::string SlicerText(const Look& look, const LookContext& context);

/// *.vp.json. Only the first component of the first property is read. There is no blend mode.
Look LookFromSlicerJson(
  const nlohmann::json& json, const std::string& file, const LookContext& context);
std::string SlicerJson(const Look& look, const LookContext& context);

}

#endif
