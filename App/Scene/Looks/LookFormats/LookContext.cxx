#include "Scene/Looks/LookFormats/LookContext.h"

#include "Core/Look/ValueRange.h"
#include "Readers/Parsing/Nesting.h"
#include "Readers/Parsing/VtkMessages.h"
#include "Scene/Looks/VolumeProperty.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace varimarch
{

namespace
{

template <class Node>
void CleanNodes(std::vector<Node>& nodes, const std::string& file)
{
  // The widths between such values are finite too.
  const auto isInRange = [](const Node& node) { return std::abs(node.value) <= LargestNumber; };
  if (!std::all_of(nodes.begin(), nodes.end(), isInRange) || nodes.size() > MostLookNodes)
  {
    FailToReadLook(file,
      nodes.size() > MostLookNodes
        ? "a curve has more than " + std::to_string(MostLookNodes) + " nodes"
        : "the value of a node is not a number from -1e300 to 1e300");
  }
  // Two nodes at one value form a step; a stable sort keeps its sides in order.
  std::stable_sort(
    nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return a.value < b.value; });
}

// NaN becomes 0.
double ToUnit(double number)
{
  return number > 0.0 ? std::min(number, 1.0) : 0.0;
}

template <class Node>
void CleanShapes(std::vector<Node>& nodes)
{
  for (Node& node : nodes)
  {
    node.shape = { ToUnit(node.shape.midpoint), ToUnit(node.shape.sharpness) };
  }
}

void CleanOpacities(std::vector<OpacityNode>& nodes, const std::string& file)
{
  CleanNodes(nodes, file);
  CleanShapes(nodes);
  for (OpacityNode& node : nodes)
  {
    node.opacity = ToUnit(node.opacity);
  }
}

glm::dvec3 CleanColor(const glm::dvec3& rgb)
{
  return { ToUnit(rgb.r), ToUnit(rgb.g), ToUnit(rgb.b) };
}

void CleanShading(Shading& shading)
{
  shading.ambient = ToUnit(shading.ambient);
  shading.diffuse = ToUnit(shading.diffuse);
  shading.specular = ToUnit(shading.specular);
  shading.specularPower = std::clamp(shading.specularPower, 1.0, 1000.0);
}

}

void FailToReadLook(const std::string& file, const std::string& message)
{
  // Words of a file may hold line breaks, and a message is one line.
  std::string line = message;
  std::replace_if(
    line.begin(), line.end(), [](unsigned char letter) { return letter < ' '; }, '?');
  throw std::runtime_error("Cannot read " + file + ": " + line + ".");
}

std::string NameOfLookFile(const std::string& path)
{
  const std::string name = std::filesystem::path(path).filename().string();
  return name.substr(0, std::max<std::size_t>(name.find('.'), 1));
}

LookContext ContextOf(vtkImageData* image)
{
  double range[2];
  image->GetPointData()->GetScalars()->GetFiniteRange(range, 0);
  return { range[0], range[1], MeanSpacingMm(image) };
}

Look CleanLook(Look look, const std::string& file, const LookContext& context)
{
  look.name = NameOfLookFile(file);
  look.opacities = look.opacities.empty() ? context.opacities : look.opacities;
  if (look.colors.empty() || look.opacities.empty())
  {
    FailToReadLook(
      file, look.colors.empty() ? "it holds no colours" : "it holds colours, but no opacities");
  }
  CleanOpacities(look.opacities, file);
  CleanOpacities(look.gradientOpacities, file);
  CleanNodes(look.colors, file);
  CleanShapes(look.colors);
  for (ColorNode& node : look.colors)
  {
    node.rgb = CleanColor(node.rgb);
  }
  CleanNodes(look.isosurfaces, file);
  CleanShading(look.shading);
  look.opacityUnitDistanceMm =
    look.opacityUnitDistanceMm > 0.0 ? look.opacityUnitDistanceMm : Look().opacityUnitDistanceMm;
  return look;
}

void Spread(Look& look, double zero, double one)
{
  for (ColorNode& node : look.colors)
  {
    node.value = zero + node.value * (one - zero);
  }
  for (OpacityNode& node : look.opacities)
  {
    node.value = zero + node.value * (one - zero);
  }
}

void TakeGradientOpacities(
  const std::vector<OpacityNode>& nodes, const LookContext& context, Look& look)
{
  const bool hasSay = std::any_of(
    nodes.begin(), nodes.end(), [](const OpacityNode& node) { return node.opacity < 1.0; });
  look.gradientOpacities = hasSay ? nodes : std::vector<OpacityNode>();
  for (OpacityNode& node : look.gradientOpacities)
  {
    node.value /= context.meanSpacingMm;
  }
}

std::vector<OpacityNode> GradientOpacitiesPerSpacing(const Look& look, const LookContext& context)
{
  std::vector<OpacityNode> nodes = look.gradientOpacities;
  for (OpacityNode& node : nodes)
  {
    node.value *= context.meanSpacingMm;
  }
  return nodes.empty() ? std::vector<OpacityNode>{ { 0.0, 1.0 }, { 255.0, 1.0 } } : nodes;
}

LookXml::LookXml(const std::string& text, const std::string& file)
{
  if (MayBeNestedTooDeep(text))
  {
    FailToReadLook(
      file, "expected at most " + std::to_string(MostNestedElements) + " elements, found more");
  }
  std::istringstream stream(text);
  VtkMessages silenced; // the error below reports the failure
  silenced.Observe(this->parser);
  this->parser->SetStream(&stream);
  const bool isValid = this->parser->Parse() && this->parser->GetRootElement();
  this->parser->SetStream(nullptr);
  if (!isValid)
  {
    FailToReadLook(file, "it is not valid XML");
  }
}

LookXml::~LookXml() = default;

vtkXMLDataElement* LookXml::Root() const
{
  return this->parser->GetRootElement();
}

std::vector<vtkXMLDataElement*> ElementsNamed(vtkXMLDataElement* top, const std::string& name)
{
  std::vector<vtkXMLDataElement*> found;
  // A recursion would exhaust the stack for a file that is nested deeply.
  std::vector<vtkXMLDataElement*> next = { top };
  while (!next.empty())
  {
    vtkXMLDataElement* const element = next.back();
    next.pop_back();
    if (vtksys::SystemTools::LowerCase(element->GetName() ? element->GetName() : "") == name)
    {
      found.push_back(element);
    }
    for (int i = element->GetNumberOfNestedElements() - 1; i >= 0; --i)
    {
      next.push_back(element->GetNestedElement(i));
    }
  }
  return found;
}

}
