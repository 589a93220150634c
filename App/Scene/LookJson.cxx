#include "Scene/LookJson.h"

#include "Scene/Presets.h"

namespace varimarch
{

namespace
{

constexpr NumberRange UnitInterval = { 0.0, 1.0 };
constexpr NumberRange Positive = { 0.0, std::numeric_limits<double>::infinity(), true };
// Curves are sampled into a table, so more nodes than this cannot be seen; it bounds the memory
// that a damaged file can ask for.
constexpr std::size_t MostNodes = 10000;

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
  for (const JsonCursor& element : json.Elements(1, MostNodes))
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

nlohmann::ordered_json JsonWithShape(nlohmann::ordered_json json, const NodeShape& shape)
{
  if (shape.midpoint != NodeShape().midpoint || shape.sharpness != NodeShape().sharpness)
  {
    json["midpoint"] = shape.midpoint;
    json["sharpness"] = shape.sharpness;
  }
  return json;
}

}

Look LookFromJson(const JsonCursor& json)
{
  if (json.IsText())
  {
    const std::string name = json.Text();
    if (!IsPresetName(name))
    {
      json.Fail("unknown preset \"" + name + "\"; " + Suggestion(name, PresetNames()));
    }
    return Preset(name);
  }
  json.RequireObject({ "name", "description", "domain", "colors", "opacities",
    "opacityUnitDistance", "shading", "blend" });
  Look look;
  if (const auto name = json.Find("name"))
  {
    look.name = name->Text();
  }
  if (const auto description = json.Find("description"))
  {
    look.description = description->Text();
  }
  if (const auto domain = json.Find("domain"))
  {
    look.domain = domain->Choice(DomainNames());
  }
  look.colors = NodesFromJson(json.At("colors"), ColorNodeFromJson);
  look.opacities = NodesFromJson(json.At("opacities"), OpacityNodeFromJson);
  if (const auto distance = json.Find("opacityUnitDistance"))
  {
    look.opacityUnitDistanceMm = distance->Number(Positive);
  }
  if (const auto shading = json.Find("shading"))
  {
    look.shading = ShadingFromJson(*shading);
  }
  if (const auto blend = json.Find("blend"))
  {
    look.blend = blend->Choice(BlendNames());
  }
  return look;
}

nlohmann::ordered_json JsonFromLook(const Look& look)
{
  nlohmann::ordered_json json;
  json["name"] = look.name;
  json["description"] = look.description;
  json["domain"] = NameOf(DomainNames(), look.domain);
  for (const ColorNode& node : look.colors)
  {
    json["colors"].push_back(JsonWithShape(
      { { "value", node.value }, { "rgb", { node.rgb.r, node.rgb.g, node.rgb.b } } }, node.shape));
  }
  for (const OpacityNode& node : look.opacities)
  {
    json["opacities"].push_back(
      JsonWithShape({ { "value", node.value }, { "opacity", node.opacity } }, node.shape));
  }
  json["opacityUnitDistance"] = look.opacityUnitDistanceMm;
  json["shading"] = { { "enabled", look.shading.enabled }, { "ambient", look.shading.ambient },
    { "diffuse", look.shading.diffuse }, { "specular", look.shading.specular },
    { "specularPower", look.shading.specularPower } };
  json["blend"] = NameOf(BlendNames(), look.blend);
  return json;
}

}
