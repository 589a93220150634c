#include "Scene/LookFormats/InviwoTransferFunction.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace varimarch
{

namespace
{

std::string LowerCaseName(vtkXMLDataElement* element)
{
  std::string name = element->GetName() ? element->GetName() : "";
  std::transform(name.begin(), name.end(), name.begin(),
    [](unsigned char letter) { return char(std::tolower(letter)); });
  return name;
}

// Finds elements by name at any depth, since the versions nest them differently.
void Collect(
  vtkXMLDataElement* element, const std::string& name, std::vector<vtkXMLDataElement*>& found)
{
  if (LowerCaseName(element) == name)
  {
    found.push_back(element);
  }
  for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
  {
    Collect(element->GetNestedElement(i), name, found);
  }
}

std::vector<vtkXMLDataElement*> ElementsOf(vtkXMLDataElement* top, const std::string& name)
{
  std::vector<vtkXMLDataElement*> found;
  Collect(top, name, found);
  return found;
}

double NumberOf(
  vtkXMLDataElement* top, const std::string& name, const char* attribute, double otherwise)
{
  double number = otherwise;
  for (vtkXMLDataElement* const element : ElementsOf(top, name))
  {
    element->GetScalarAttribute(attribute, number);
  }
  return number;
}

void TakePoint(vtkXMLDataElement* point, const std::string& file, Look& look)
{
  const std::vector<vtkXMLDataElement*> rgba = ElementsOf(point, "rgba");
  double position = NumberOf(point, "pos", "x", -1e300);
  position = NumberOf(point, "pos", "content", position);
  glm::dvec4 color(0.0);
  const char* const names[] = { "x", "y", "z", "w" };
  for (int i = 0; i < 4 && !rgba.empty(); ++i)
  {
    rgba.front()->GetScalarAttribute(names[i], color[i]);
  }
  if (rgba.empty() || position == -1e300)
  {
    FailToReadLook(file, "a point has no position or no colour");
  }
  look.colors.push_back({ position, glm::dvec3(color) });
  look.opacities.push_back({ position, color.w });
}

// Makes everything outside an interval transparent.
void HideOutside(Look& look, double first, double last)
{
  const TransferFunction function(look.colors, look.opacities, look.opacityUnitDistanceMm);
  std::vector<OpacityNode> left = { { first, 0.0 }, { first, function.Opacity(first) } };
  for (const OpacityNode& node : look.opacities)
  {
    if (node.value > first && node.value < last)
    {
      left.push_back(node);
    }
  }
  left.push_back({ last, function.Opacity(last) });
  left.push_back({ last, 0.0 });
  look.opacities = left;
}

}

Look LookFromItf(const std::string& text, const std::string& file, const LookContext& context)
{
  std::istringstream stream(text);
  vtkNew<vtkXMLDataParser> parser;
  // While an observer listens to errors, VTK does not print them; the error below reports the
  // failure.
  parser->AddObserver(vtkCommand::ErrorEvent, vtkNew<vtkCallbackCommand>());
  parser->SetStream(&stream);
  vtkXMLDataElement* const top = parser->Parse() ? parser->GetRootElement() : nullptr;
  if (!top)
  {
    FailToReadLook(file, "it is not valid XML");
  }
  Look look;
  for (vtkXMLDataElement* const point : ElementsOf(top, "point"))
  {
    TakePoint(point, file, look);
  }
  look = CleanLook(look, file, context);
  const double first = NumberOf(top, "maskmin", "content", 0.0);
  const double last = NumberOf(top, "maskmax", "content", 1.0);
  const bool atValues = NumberOf(top, "type", "content", 0.0) == 1.0;
  if (!atValues && last > first && (first > 0.0 || last < 1.0))
  {
    HideOutside(look, first, last);
  }
  if (!atValues)
  {
    Spread(look, context.smallest, context.largest);
  }
  return look;
}

}
