#include "Scene/Looks/LookFormats/LookFormats.h"

#include "Scene/Json/JsonCursor.h"

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace varimarch
{

namespace
{

// Subdivisions between two colours of a file whose colour space is not RGB.
constexpr int StepsBetween = 8;

std::vector<double> NodeNumbersOf(const JsonCursor& json, std::size_t perNode)
{
  std::vector<double> numbers;
  for (const JsonCursor& element : json.Elements(perNode, perNode * MostLookNodes))
  {
    numbers.push_back(element.Number());
  }
  if (numbers.size() % perNode != 0)
  {
    json.Fail("expected " + std::to_string(perNode) + " numbers for each node, found " +
      std::to_string(numbers.size()) + " in all");
  }
  return numbers;
}

std::vector<OpacityNode> OpacitiesOf(const JsonCursor& points)
{
  const std::vector<double> numbers = NodeNumbersOf(points, 4);
  std::vector<OpacityNode> nodes;
  for (std::size_t i = 0; i < numbers.size(); i += 4)
  {
    nodes.push_back({ numbers[i], numbers[i + 1], { numbers[i + 2], numbers[i + 3] } });
  }
  return nodes;
}

std::vector<ColorNode> ColorsOfPoints(const JsonCursor& points)
{
  const std::vector<double> numbers = NodeNumbersOf(points, 4);
  std::vector<ColorNode> nodes;
  for (std::size_t i = 0; i < numbers.size(); i += 4)
  {
    nodes.push_back({ numbers[i], { numbers[i + 1], numbers[i + 2], numbers[i + 3] } });
  }
  return nodes;
}

bool SetColorSpace(const std::string& name, vtkColorTransferFunction* function)
{
  function->SetColorSpaceToRGB();
  if (name == "HSV")
  {
    function->SetColorSpaceToHSV();
  }
  else if (name == "Lab" || name == "CIELAB" || name == "Lab/CIEDE2000")
  {
    function->SetColorSpaceToLab();
  }
  else if (name == "Diverging")
  {
    function->SetColorSpaceToDiverging();
  }
  return function->GetColorSpace() != VTK_CTF_RGB;
}

// Approximates another colour space by nodes with linear interpolation in RGB.
std::vector<ColorNode> StraightInRgb(const std::vector<ColorNode>& nodes, const std::string& space)
{
  vtkNew<vtkColorTransferFunction> function;
  if (!SetColorSpace(space, function))
  {
    return nodes;
  }
  function->AllowDuplicateScalarsOn();
  for (const ColorNode& node : nodes)
  {
    function->AddRGBPoint(node.value, node.rgb.r, node.rgb.g, node.rgb.b);
  }
  std::vector<ColorNode> straight;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
  {
    straight.push_back(nodes[i]);
    const double width = nodes[i + 1].value - nodes[i].value;
    for (int step = 1; step < StepsBetween && width > 0.0; ++step)
    {
      const double value = nodes[i].value + width * step / StepsBetween;
      glm::dvec3 rgb;
      function->GetColor(value, &rgb.x);
      straight.push_back({ value, rgb });
    }
  }
  straight.push_back(nodes.back());
  return straight;
}

// Maps are stored on [0, 1] or [-1, 1], and rescaled when used.
bool IsOnUnitScale(const Look& look, const LookContext& context)
{
  double first = look.colors.front().value;
  double last = look.colors.back().value;
  for (const OpacityNode& node : look.opacities)
  {
    first = std::min(first, node.value);
    last = std::max(last, node.value);
  }
  return first >= -1.0 && last <= 1.0 && context.largest - context.smallest > 2.0;
}

// Maps the first and last value of the file to the given range, as ParaView does.
void Rescale(Look& look, double smallest, double largest)
{
  const double first = look.colors.front().value;
  const double width = look.colors.back().value - first;
  const double scale = width > 0.0 ? (largest - smallest) / width : 0.0;
  Spread(look, smallest - scale * first, smallest - scale * first + scale);
}

}

bool IsParaViewColorMap(const nlohmann::json& json)
{
  return json.is_array() || (json.is_object() && json.contains("RGBPoints"));
}

Look LookFromParaViewJson(
  const nlohmann::json& json, const std::string& file, const LookContext& context)
{
  const JsonCursor top(json, file);
  const JsonCursor map = json.is_array() ? top.Elements(1, MostLookNodes).front() : top;
  const auto space = map.Find("ColorSpace");
  Look look;
  look.shading.enabled = false;
  look.colors = ColorsOfPoints(map.At("RGBPoints"));
  if (const auto points = map.Find("Points"))
  {
    look.opacities = OpacitiesOf(*points);
  }
  const bool colorsAlone = look.opacities.empty();
  const bool onUnitScale = IsOnUnitScale(look, context);
  if (onUnitScale && !colorsAlone)
  {
    Rescale(look, context.smallest, context.largest);
  }
  else if (onUnitScale && !context.opacities.empty())
  {
    Rescale(look, context.opacities.front().value, context.opacities.back().value);
  }
  look = CleanLook(look, file, context);
  look.colors = StraightInRgb(look.colors, space ? space->Text() : "RGB");
  return look;
}

std::string ParaViewJson(const Look& look)
{
  nlohmann::ordered_json colors = nlohmann::ordered_json::array();
  for (const ColorNode& node : look.colors)
  {
    for (const double number : { node.value, node.rgb.r, node.rgb.g, node.rgb.b })
    {
      colors.push_back(number);
    }
  }
  nlohmann::ordered_json opacities = nlohmann::ordered_json::array();
  for (const OpacityNode& node : look.opacities)
  {
    for (const double number :
      { node.value, node.opacity, node.shape.midpoint, node.shape.sharpness })
    {
      opacities.push_back(number);
    }
  }
  const nlohmann::ordered_json map = { { "ColorSpace", "RGB" }, { "Name", look.name },
    { "Points", opacities }, { "RGBPoints", colors } };
  return TextFromJson(nlohmann::ordered_json::array({ map }));
}

}
