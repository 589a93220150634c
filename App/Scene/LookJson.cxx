#include "Scene/LookJson.h"
#include "Scene/ChannelsJson.h"
#include "Scene/LightsJson.h"
#include "Scene/LookFormats/LookContext.h"
#include "Scene/Presets.h"
#include "Scene/RegionsJson.h"

#include <nlohmann/json.hpp>

namespace varimarch
{

namespace
{

NodeShape ShapeFromJson(const JsonCursor& json)
{
  NodeShape shape;
  if (const auto midpoint = json.Find("midpoint"))
  {
    shape.midpoint = midpoint->Number(UnitInterval);
  }
  if (const auto sharpness = json.Find("sharpness"))
  {
    shape.sharpness = sharpness->Number(UnitInterval);
  }
  return shape;
}

ColorNode ColorNodeFromJson(const JsonCursor& json)
{
  json.RequireObject({ "value", "rgb", "midpoint", "sharpness" });
  const std::array<double, 3> rgb = json.At("rgb").Numbers<3>(UnitInterval);
  return { json.At("value").Number(), { rgb[0], rgb[1], rgb[2] }, ShapeFromJson(json) };
}

OpacityNode OpacityNodeFromJson(const JsonCursor& json)
{
  json.RequireObject({ "value", "opacity", "midpoint", "sharpness" });
  return { json.At("value").Number(), json.At("opacity").Number(UnitInterval),
    ShapeFromJson(json) };
}

template <class Node>
std::vector<Node> NodesFromJson(const JsonCursor& json, Node (*nodeFromJson)(const JsonCursor&))
{
  std::vector<Node> nodes;
  for (const JsonCursor& element : json.Elements(1, MostLookNodes))
  {
    nodes.push_back(nodeFromJson(element));
    if (nodes.size() > 1 && nodes.back().value < nodes[nodes.size() - 2].value)
    {
      element.At("value").Fail("expected nodes in the order of their values, found one below the "
                               "node before it");
    }
  }
  return nodes;
}

Shading ShadingFromJson(const JsonCursor& json)
{
  json.RequireObject({ "enabled", "ambient", "diffuse", "specular", "specularPower" });
  Shading shading;
  if (const auto enabled = json.Find("enabled"))
  {
    shading.enabled = enabled->Boolean();
  }
  const auto read = [&](const char* key, double& number, const NumberRange& range)
  {
    if (const auto found = json.Find(key))
    {
      number = found->Number(range);
    }
  };
  read("ambient", shading.ambient, UnitInterval);
  read("diffuse", shading.diffuse, UnitInterval);
  read("specular", shading.specular, UnitInterval);
  read("specularPower", shading.specularPower, { 1.0, 1000.0 });
  return shading;
}

Isosurface IsosurfaceFromJson(const JsonCursor& json)
{
  json.RequireObject({ "value", "rgb", "opacity" });
  const std::array<double, 3> rgb = json.At("rgb").Numbers<3>(UnitInterval);
  Isosurface surface = { json.At("value").Number(), { rgb[0], rgb[1], rgb[2] } };
  if (const auto opacity = json.Find("opacity"))
  {
    surface.opacity = opacity->Number(UnitInterval);
  }
  return surface;
}

std::array<double, 2> RangeFromJson(const JsonCursor& json)
{
  const std::array<double, 2> range = json.Numbers<2>();
  if (range[0] > range[1])
  {
    json.Fail("expected the smaller value first, found the larger first");
  }
  return range;
}

void ReadTexts(const JsonCursor& json, Look& look)
{
  if (const auto name = json.Find("name"))
  {
    look.name = name->Text();
  }
  if (const auto description = json.Find("description"))
  {
    look.description = description->Text();
  }
}

// Reads the blend mode and the keys that only some blend modes use.
void ReadBlend(const JsonCursor& json, Look& look)
{
  if (const auto surfaces = json.Find("isosurfaces"))
  {
    look.isosurfaces = NodesFromJson(*surfaces, IsosurfaceFromJson);
  }
  if (const auto range = json.Find("averagedRange"))
  {
    look.averagedRange = RangeFromJson(*range);
  }
  if (const auto blend = json.Find("blend"))
  {
    look.blend = blend->Choice(BlendNames());
    if (look.blend == Blend::Isosurface && look.isosurfaces.empty())
    {
      json.Fail("the blend mode \"isosurface\" expects the key \"isosurfaces\", found none");
    }
  }
}

nlohmann::ordered_json JsonWithShape(nlohmann::ordered_json json, const NodeShape& shape)
{
  if (shape.midpoint != NodeShape().midpoint || shape.sharpness != NodeShape().sharpness)
  {
    json["midpoint"] = shape.midpoint;
    json["sharpness"] = shape.sharpness;
  }
  return json;
}

nlohmann::ordered_json JsonFromOpacities(const std::vector<OpacityNode>& nodes)
{
  nlohmann::ordered_json json;
  for (const OpacityNode& node : nodes)
  {
    json.push_back(
      JsonWithShape({ { "value", node.value }, { "opacity", node.opacity } }, node.shape));
  }
  return json;
}

// Adds the curves and what belongs to them.
void AddCurves(const Look& look, nlohmann::ordered_json& json)
{
  json["domain"] = NameOf(DomainNames(), look.domain);
  for (const ColorNode& node : look.colors)
  {
    json["colors"].push_back(JsonWithShape(
      { { "value", node.value }, { "rgb", { node.rgb.r, node.rgb.g, node.rgb.b } } }, node.shape));
  }
  json["opacities"] = JsonFromOpacities(look.opacities);
  if (look.lengths != Lengths::Millimetres)
  {
    json["lengths"] = NameOf(LengthsNames(), look.lengths);
  }
  json["opacityUnitDistance"] = look.opacityUnitDistanceMm;
  if (!look.gradientOpacities.empty())
  {
    json["gradientOpacities"] = JsonFromOpacities(look.gradientOpacities);
  }
  if (!look.channels.empty())
  {
    json["channels"] = JsonFromChannels(look.channels);
  }
  if (!look.regions.empty())
  {
    json["regions"] = JsonFromRegions(look.regions);
  }
}

Look LookFromJson(const JsonCursor& json)
{
  Look look;
  ReadTexts(json, look);
  if (const auto domain = json.Find("domain"))
  {
    look.domain = domain->Choice(DomainNames());
  }
  look.colors = NodesFromJson(json.At("colors"), ColorNodeFromJson);
  look.opacities = NodesFromJson(json.At("opacities"), OpacityNodeFromJson);
  if (const auto lengths = json.Find("lengths"))
  {
    look.lengths = lengths->Choice(LengthsNames());
  }
  if (const auto distance = json.Find("opacityUnitDistance"))
  {
    look.opacityUnitDistanceMm = distance->Number(Positive);
  }
  if (const auto nodes = json.Find("gradientOpacities"))
  {
    look.gradientOpacities = NodesFromJson(*nodes, OpacityNodeFromJson);
  }
  if (const auto shading = json.Find("shading"))
  {
    look.shading = ShadingFromJson(*shading);
  }
  if (const auto channels = json.Find("channels"))
  {
    look.channels = ChannelsFromJson(*channels);
  }
  if (const auto regions = json.Find("regions"))
  {
    look.regions = RegionsFromJson(*regions);
  }
  if (const auto damping = json.Find("damping"))
  {
    look.dampingGradient = damping->Number({ 0.0 });
  }
  ReadBlend(json, look);
  return look;
}

}

Preset PresetFromJson(const JsonCursor& json)
{
  if (json.IsText())
  {
    const std::string name = json.Text();
    if (!IsPresetName(name))
    {
      json.Fail("unknown preset \"" + name + "\"; " + Suggestion(name, PresetNames()));
    }
    return BuiltInPreset(name);
  }
  json.RequireObject({ "name", "description", "domain", "colors", "opacities", "lengths",
    "opacityUnitDistance", "channels", "gradientOpacities", "regions", "shading", "damping",
    "blend", "isosurfaces", "averagedRange", "errorTolerance", "background", "light" });
  Preset preset = { LookFromJson(json) };
  if (const auto tolerance = json.Find("errorTolerance"))
  {
    preset.errorTolerance = tolerance->Number(UnitInterval);
  }
  if (const auto background = json.Find("background"))
  {
    preset.background = background->Numbers<3>(UnitInterval);
  }
  if (const auto light = json.Find("light"))
  {
    light->RequireObject(LightingKeys());
    preset.light = LightingFromJson(*light);
  }
  return preset;
}

nlohmann::ordered_json JsonFromLook(const Look& look)
{
  nlohmann::ordered_json json;
  json["name"] = look.name;
  json["description"] = look.description;
  AddCurves(look, json);
  json["shading"] = { { "enabled", look.shading.enabled }, { "ambient", look.shading.ambient },
    { "diffuse", look.shading.diffuse }, { "specular", look.shading.specular },
    { "specularPower", look.shading.specularPower } };
  if (look.dampingGradient > 0.0)
  {
    json["damping"] = look.dampingGradient;
  }
  json["blend"] = NameOf(BlendNames(), look.blend);
  for (const Isosurface& surface : look.isosurfaces)
  {
    json["isosurfaces"].push_back({ { "value", surface.value },
      { "rgb", { surface.rgb.r, surface.rgb.g, surface.rgb.b } }, { "opacity", surface.opacity } });
  }
  if (look.averagedRange)
  {
    json["averagedRange"] = *look.averagedRange;
  }
  return json;
}

nlohmann::ordered_json JsonFromPreset(const Preset& preset)
{
  nlohmann::ordered_json json = JsonFromLook(preset.look);
  if (preset.errorTolerance)
  {
    json["errorTolerance"] = *preset.errorTolerance;
  }
  if (preset.background)
  {
    json["background"] = *preset.background;
  }
  if (preset.light)
  {
    json["light"] = nlohmann::ordered_json::object(); // also where all of it is off
    AddLighting(*preset.light, json["light"]);
  }
  return json;
}

}
