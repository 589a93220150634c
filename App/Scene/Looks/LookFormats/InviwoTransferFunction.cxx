#include "Scene/Looks/LookFormats/LookFormats.h"

#include "Scene/Looks/LookFormats/LookContext.h"

#include <vtkXMLDataElement.h>

#include <glm/vec4.hpp>

#include <algorithm>

namespace varimarch
{

namespace
{

double NumberOf(
  vtkXMLDataElement* top, const std::string& name, const char* attribute, double otherwise)
{
  double number = otherwise;
  for (vtkXMLDataElement* const element : ElementsNamed(top, name))
  {
    element->GetScalarAttribute(attribute, number);
  }
  return number;
}

void TakePoint(vtkXMLDataElement* point, const std::string& file, Look& look)
{
  const std::vector<vtkXMLDataElement*> rgba = ElementsNamed(point, "rgba");
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
  // The versions nest the elements differently, so they are found at any depth.
  const LookXml xml(text, file);
  vtkXMLDataElement* const top = xml.Root();
  Look look;
  for (vtkXMLDataElement* const point : ElementsNamed(top, "point"))
  {
    TakePoint(point, file, look);
  }
  look = CleanLook(look, file, context);
  const double first = std::max(NumberOf(top, "maskmin", "content", 0.0), 0.0);
  const double last = std::min(NumberOf(top, "maskmax", "content", 1.0), 1.0);
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
