#include "Scene/JsonCursor.h"
#include "Scene/LookFormats/SlicerProperty.h"

#include <nlohmann/json.hpp>

namespace varimarch
{

namespace
{

constexpr const char* Schema =
  "https://raw.githubusercontent.com/Slicer/Slicer/main/Modules/Loadable/VolumeRendering/Resources/"
  "Schema/volume-property-schema-v1.0.0.json#";

double NumberOr(const JsonCursor& json, const char* key, double otherwise)
{
  const auto found = json.Find(key);
  return found ? found->Number() : otherwise;
}

bool BooleanOr(const JsonCursor& json, const char* key, bool otherwise)
{
  const auto found = json.Find(key);
  return found ? found->Boolean() : otherwise;
}

NodeShape ShapeOf(const JsonCursor& point)
{
  return { NumberOr(point, "midpoint", NodeShape().midpoint),
    NumberOr(point, "sharpness", NodeShape().sharpness) };
}

std::vector<JsonCursor> PointsOf(const JsonCursor& function)
{
  return function.At("points").Elements(0, MostLookNodes);
}

std::vector<OpacityNode> CurveOf(const JsonCursor& function)
{
  std::vector<OpacityNode> nodes;
  for (const JsonCursor& point : PointsOf(function))
  {
    nodes.push_back({ point.At("x").Number(), point.At("y").Number(), ShapeOf(point) });
  }
  return nodes;
}

std::vector<ColorNode> ColorsOf(const JsonCursor& function)
{
  std::vector<ColorNode> nodes;
  for (const JsonCursor& point : PointsOf(function))
  {
    const std::array<double, 3> rgb = point.At("color").Numbers<3>();
    nodes.push_back({ point.At("x").Number(), { rgb[0], rgb[1], rgb[2] }, ShapeOf(point) });
  }
  return nodes;
}

Shading ShadingOf(const JsonCursor& component)
{
  Shading shading;
  shading.enabled = BooleanOr(component, "shade", false);
  if (const auto lighting = component.Find("lighting"))
  {
    shading.ambient = NumberOr(*lighting, "ambient", shading.ambient);
    shading.diffuse = NumberOr(*lighting, "diffuse", shading.diffuse);
    shading.specular = NumberOr(*lighting, "specular", shading.specular);
    shading.specularPower = NumberOr(*lighting, "specularPower", shading.specularPower);
  }
  return shading;
}

// Isosurfaces take their colour and opacity from the curves.
std::vector<Isosurface> SurfacesAt(const std::vector<JsonCursor>& values, const Look& look)
{
  const TransferFunction function(look.colors, look.opacities, look.opacityUnitDistanceMm);
  std::vector<Isosurface> surfaces;
  for (const JsonCursor& json : values)
  {
    const double value = json.Number();
    surfaces.push_back({ value, function.Color(value), function.Opacity(value) });
  }
  return surfaces;
}

nlohmann::ordered_json WithShape(nlohmann::ordered_json json, const NodeShape& shape)
{
  json["midpoint"] = shape.midpoint;
  json["sharpness"] = shape.sharpness;
  return json;
}

nlohmann::ordered_json JsonOf(const std::vector<OpacityNode>& nodes)
{
  nlohmann::ordered_json points = nlohmann::ordered_json::array();
  for (const OpacityNode& node : nodes)
  {
    points.push_back(WithShape({ { "x", node.value }, { "y", node.opacity } }, node.shape));
  }
  return { { "type", "piecewiseLinearFunction" }, { "points", points } };
}

nlohmann::ordered_json JsonOf(const std::vector<ColorNode>& nodes)
{
  nlohmann::ordered_json points = nlohmann::ordered_json::array();
  for (const ColorNode& node : nodes)
  {
    points.push_back(WithShape(
      { { "x", node.value }, { "color", { node.rgb.r, node.rgb.g, node.rgb.b } } }, node.shape));
  }
  return { { "type", "colorTransferFunction" }, { "points", points } };
}

}

Look LookFromSlicerJson(
  const nlohmann::json& json, const std::string& file, const LookContext& context)
{
  const JsonCursor property =
    JsonCursor(json, file).At("volumeProperties").Elements(1, MostLookNodes).front();
  const JsonCursor component = property.At("components").Elements(1, MostLookNodes).front();
  Look look;
  look.shading = ShadingOf(component);
  look.opacityUnitDistanceMm =
    NumberOr(component, "scalarOpacityUnitDistance", look.opacityUnitDistanceMm);
  look.colors = ColorsOf(component.At("rgbTransferFunction"));
  look.opacities = CurveOf(component.At("scalarOpacity"));
  const auto gradients = component.Find("gradientOpacity");
  if (gradients && !BooleanOr(component, "disableGradientOpacity", false))
  {
    TakeGradientOpacities(CurveOf(*gradients), context, look);
  }
  look = CleanLook(look, file, context);
  if (const auto values = property.Find("isoSurfaceValues"))
  {
    look.isosurfaces = SurfacesAt(values->Elements(0, MostLookNodes), look);
  }
  return CleanLook(look, file, context);
}

std::string SlicerJson(const Look& look, const LookContext& context)
{
  const TransferFunction function(look.colors, look.opacities, look.opacityUnitDistanceMm);
  nlohmann::ordered_json values = nlohmann::ordered_json::array();
  for (const Isosurface& surface : look.isosurfaces)
  {
    values.push_back(surface.value);
  }
  const nlohmann::ordered_json component = { { "componentWeight", 1.0 },
    { "shade", look.shading.enabled },
    { "lighting",
      { { "diffuse", look.shading.diffuse }, { "ambient", look.shading.ambient },
        { "specular", look.shading.specular }, { "specularPower", look.shading.specularPower } } },
    { "disableGradientOpacity", look.gradientOpacities.empty() },
    { "scalarOpacityUnitDistance", look.opacityUnitDistanceMm },
    { "rgbTransferFunction", JsonOf(look.colors) }, { "scalarOpacity", JsonOf(look.opacities) },
    { "gradientOpacity", JsonOf(GradientOpacitiesPerSpacing(look, context)) } };
  const nlohmann::ordered_json property = { { "effectiveRange",
                                              { function.FirstValue(), function.LastValue() } },
    { "isoSurfaceValues", values }, { "independentComponents", true },
    { "interpolationType", "linear" }, { "components", { component } } };
  return TextFromJson({ { "@schema", Schema }, { "volumeProperties", { property } } });
}

}
