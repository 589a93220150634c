#include "Scene/LookFormats/SlicerScene.h"

#include "Scene/LookFormats/LookXml.h"
#include "Scene/LookFormats/SlicerProperty.h"

#include <vtkXMLDataElement.h>

namespace varimarch
{

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
