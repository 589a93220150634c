#include "Scene/LookFormats/LookXml.h"

#include "Readers/Nesting.h"
#include "Readers/VtkMessages.h"
#include "Scene/LookFormats/LookContext.h"

#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>
#include <vtksys/SystemTools.hxx>

#include <sstream>

namespace varimarch
{

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
