#include "Scene/LightsJson.h"

#include <nlohmann/json.hpp>

namespace varimarch
{

namespace
{

// Each kind of light has its own keys, so that a place that it ignores is an error.
std::vector<std::string> KeysOf(LightKind kind)
{
  switch (kind)
  {
    case LightKind::Camera:
    case LightKind::Directional:
      return { "kind", "direction", "color", "intensity", "softness" };
    case LightKind::Positional:
      return { "kind", "position", "color", "intensity", "softness" };
    default:
      return { "kind", "color", "intensity" };
  }
}

SceneLight LightFromJson(const JsonCursor& json)
{
  SceneLight light;
  light.kind = json.At("kind").Choice(LightKindNames());
  json.RequireObject(KeysOf(light.kind));
  if (light.kind == LightKind::Camera || light.kind == LightKind::Directional)
  {
    light.direction = json.At("direction").Numbers<3>();
    if (light.direction == std::array<double, 3>{})
    {
      json.At("direction").Fail("expected a vector towards the light, found one of length 0");
    }
  }
  if (light.kind == LightKind::Positional)
  {
    light.positionMm = json.At("position").Numbers<3>();
  }
  if (const auto color = json.Find("color"))
  {
    light.rgb = color->Numbers<3>({ 0.0, 1.0 });
  }
  if (const auto intensity = json.Find("intensity"))
  {
    light.intensity = intensity->Number({ 0.0, 1000.0, true });
  }
  if (const auto softness = json.Find("softness"))
  {
    light.softnessDegrees = softness->Number({ 0.0, 60.0 });
  }
  return light;
}

nlohmann::ordered_json JsonFromLight(const SceneLight& light)
{
  nlohmann::ordered_json json = { { "kind", NameOf(LightKindNames(), light.kind) } };
  if (light.kind == LightKind::Camera || light.kind == LightKind::Directional)
  {
    json["direction"] = light.direction;
  }
  if (light.kind == LightKind::Positional)
  {
    json["position"] = light.positionMm;
  }
  json["color"] = light.rgb;
  json["intensity"] = light.intensity;
  if (light.softnessDegrees > 0.0)
  {
    json["softness"] = light.softnessDegrees;
  }
  return json;
}

std::vector<SceneLight> LightsFromJson(const JsonCursor& json)
{
  std::vector<SceneLight> lights;
  for (const JsonCursor& element : json.Elements(0, MostLights))
  {
    lights.push_back(LightFromJson(element));
  }
  return lights;
}

nlohmann::ordered_json JsonFromLights(const std::vector<SceneLight>& lights)
{
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const SceneLight& light : lights)
  {
    json.push_back(JsonFromLight(light));
  }
  return json;
}

// Whether there are shadows, or their strength.
double ShadowsFromJson(const JsonCursor& json)
{
  return json.IsBoolean() ? double(json.Boolean()) : json.Number(UnitInterval);
}

Scattering ScatteringFromJson(const JsonCursor& json)
{
  Scattering scattering;
  json.RequireObject({ "blending", "anisotropy", "reach" });
  scattering.blending = json.At("blending").Number({ 0.0, 2.0 });
  if (const auto anisotropy = json.Find("anisotropy"))
  {
    scattering.anisotropy = anisotropy->Number({ -0.99, 0.99 });
  }
  if (const auto reach = json.Find("reach"))
  {
    scattering.reach = reach->Number({ 0.0, 1.0 });
  }
  return scattering;
}

Occlusion OcclusionFromJson(const JsonCursor& json)
{
  Occlusion occlusion;
  json.RequireObject({ "strength", "reach" });
  occlusion.strength = json.At("strength").Number({ 0.0, 1.0 });
  if (const auto reach = json.Find("reach"))
  {
    occlusion.reachMm = reach->Number({ 0.0 });
  }
  return occlusion;
}

}

std::vector<std::string> LightingKeys()
{
  return { "lights", "shadows", "scattering", "occlusion" };
}

Lighting LightingFromJson(const JsonCursor& json)
{
  Lighting lighting;
  if (const auto lights = json.Find("lights"))
  {
    lighting.lights = LightsFromJson(*lights);
  }
  if (const auto shadows = json.Find("shadows"))
  {
    lighting.shadows = ShadowsFromJson(*shadows);
  }
  if (const auto scattering = json.Find("scattering"))
  {
    lighting.scattering = ScatteringFromJson(*scattering);
  }
  if (const auto occlusion = json.Find("occlusion"))
  {
    lighting.occlusion = OcclusionFromJson(*occlusion);
  }
  return lighting;
}

void AddLighting(const Lighting& lighting, nlohmann::ordered_json& json)
{
  if (!lighting.lights.empty())
  {
    json["lights"] = JsonFromLights(lighting.lights);
  }
  if (lighting.shadows == 1.0)
  {
    json["shadows"] = true;
  }
  else if (lighting.shadows > 0.0)
  {
    json["shadows"] = lighting.shadows;
  }
  const Scattering& scattering = lighting.scattering;
  if (scattering.blending > 0.0)
  {
    json["scattering"] = { { "blending", scattering.blending },
      { "anisotropy", scattering.anisotropy }, { "reach", scattering.reach } };
  }
  const Occlusion& occlusion = lighting.occlusion;
  if (occlusion.strength > 0.0)
  {
    json["occlusion"] = { { "strength", occlusion.strength }, { "reach", occlusion.reachMm } };
  }
}

}
