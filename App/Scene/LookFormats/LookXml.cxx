#include "Scene/LookFormats/LookXml.h"

#include "Scene/LookFormats/LookContext.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>
#include <vtksys/SystemTools.hxx>

#include <sstream>

namespace varimarch
{

namespace
{

void Collect(
  vtkXMLDataElement* element, const std::string& name, std::vector<vtkXMLDataElement*>& found)
{
  if (vtksys::SystemTools::LowerCase(element->GetName() ? element->GetName() : "") == name)
  {
    found.push_back(element);
  }
  for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
  {
    Collect(element->GetNestedElement(i), name, found);
  }
}

}

LookXml::LookXml(const std::string& text, const std::string& file)
{
  std::istringstream stream(text);
  // While an observer listens to errors, VTK does not print them; the error below reports the
  // failure.
  this->parser->AddObserver(vtkCommand::ErrorEvent, vtkNew<vtkCallbackCommand>());
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
  Collect(top, name, found);
  return found;
}

}
