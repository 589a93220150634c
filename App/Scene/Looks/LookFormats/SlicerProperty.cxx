#include "Scene/Looks/LookFormats/LookFormats.h"

#include "Scene/Json/JsonCursor.h"

#include <vtkXMLDataElement.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <vector>

namespace varimarch
{

namespace
{

// A colour node has four numbers.
constexpr std::size_t MostNumbers = 4 * MostLookNodes;

/// The numbers of a text that contains nothing else.
std::vector<double> NumbersOfText(
  const std::string& text, const std::string& file, const char* what)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  std::vector<double> numbers;
  double number = 0.0;
  while (numbers.size() <= MostNumbers && stream >> number)
  {
    numbers.push_back(number);
  }
  stream >> std::ws;
  if (numbers.empty() || !stream.eof())
  {
    FailToReadLook(file,
      std::string("expected numbers for the ") + what + ", found \"" + text.substr(0, 40) + "\"");
  }
  return numbers;
}

/// The numbers of a curve, without the count in front of them.
std::vector<double> NumbersOfCurve(
  const std::string& text, const std::string& file, const char* what, std::size_t perNode)
{
  std::vector<double> numbers = NumbersOfText(text, file, what);
  const double promised = numbers.front();
  numbers.erase(numbers.begin());
  if (promised != double(numbers.size()) || numbers.empty() || numbers.size() % perNode != 0)
  {
    FailToReadLook(file,
      std::string("the ") + what + " promises " +
        std::to_string(std::lround(std::clamp(promised, -1e9, 1e9))) + " numbers, " +
        std::to_string(perNode) + " for each node, the line holds " +
        std::to_string(numbers.size()));
  }
  return numbers;
}

std::vector<OpacityNode> OpacitiesOf(const std::vector<double>& numbers)
{
  std::vector<OpacityNode> nodes;
  for (std::size_t i = 0; i < numbers.size(); i += 2)
  {
    nodes.push_back({ numbers[i], numbers[i + 1] });
  }
  return nodes;
}

void WriteOpacities(std::ostream& text, const std::vector<OpacityNode>& nodes)
{
  text << 2 * nodes.size();
  for (const OpacityNode& node : nodes)
  {
    text << ' ' << node.value << ' ' << node.opacity;
  }
  text << '\n';
}

}

Look LookFromSlicerNumbers(
  const SlicerNumbers& texts, const std::string& file, const LookContext& context)
{
  const auto number = [&](const std::string& text, const char* what)
  { return NumbersOfText(text, file, what).front(); };
  Look look;
  look.shading.enabled = number(texts.shade, "shading") != 0.0;
  look.shading.diffuse = number(texts.diffuse, "diffuse coefficient");
  look.shading.ambient = number(texts.ambient, "ambient coefficient");
  look.shading.specular = number(texts.specular, "specular coefficient");
  look.shading.specularPower = number(texts.specularPower, "specular power");
  look.opacities = OpacitiesOf(NumbersOfCurve(texts.scalarOpacity, file, "scalar opacity", 2));
  TakeGradientOpacities(
    OpacitiesOf(NumbersOfCurve(texts.gradientOpacity, file, "gradient opacity", 2)), context, look);
  const auto colors = NumbersOfCurve(texts.colors, file, "colours", 4);
  for (std::size_t i = 0; i < colors.size(); i += 4)
  {
    look.colors.push_back({ colors[i], { colors[i + 1], colors[i + 2], colors[i + 3] } });
  }
  return CleanLook(look, file, context);
}

Look LookFromSlicerText(
  const std::string& text, const std::string& file, const LookContext& context)
{
  std::istringstream lines(text);
  std::string interpolation;
  std::getline(lines, interpolation);
  NumbersOfText(interpolation, file, "interpolation");
  SlicerNumbers texts;
  for (std::string* const line : { &texts.shade, &texts.diffuse, &texts.ambient, &texts.specular,
         &texts.specularPower, &texts.scalarOpacity, &texts.gradientOpacity, &texts.colors })
  {
    std::getline(lines, *line);
  }
  return LookFromSlicerNumbers(texts, file, context);
}

std::string SlicerText(const Look& look, const LookContext& context)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  text << "1\n"
       << int(look.shading.enabled) << '\n'
       << look.shading.diffuse << '\n'
       << look.shading.ambient << '\n'
       << look.shading.specular << '\n'
       << look.shading.specularPower << '\n';
  WriteOpacities(text, look.opacities);
  WriteOpacities(text, GradientOpacitiesPerSpacing(look, context));
  text << 4 * look.colors.size();
  for (const ColorNode& node : look.colors)
  {
    text << ' ' << node.value << ' ' << node.rgb.r << ' ' << node.rgb.g << ' ' << node.rgb.b;
  }
  text << '\n';
  return text.str();
}

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

namespace
{

Look LookOf(vtkXMLDataElement* property, const std::string& file, const LookContext& context)
{
  const auto text = [&](const char* attribute)
  {
    const char* const value = property->GetAttribute(attribute);
    return std::string(value ? value : "");
  };
  Look look = LookFromSlicerNumbers(
    { text("shade"), text("diffuse"), text("ambient"), text("specular"), text("specularPower"),
      text("scalarOpacity"), text("gradientOpacity"), text("colorTransfer") },
    file, context);
  look.name = text("name");
  return look;
}

}

std::vector<Look> LooksFromSlicerScene(
  const std::string& text, const std::string& file, const LookContext& context)
{
  const LookXml xml(text, file);
  std::vector<Look> looks;
  for (vtkXMLDataElement* const property : ElementsNamed(xml.Root(), "volumeproperty"))
  {
    looks.push_back(LookOf(property, file, context));
  }
  if (looks.empty())
  {
    FailToReadLook(file, "it is not a scene of 3D Slicer with volume properties");
  }
  return looks;
}

}
