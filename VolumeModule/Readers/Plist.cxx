#include "Readers/Plist.h"

#include "Readers/FileError.h"
#include "Readers/VtkMessages.h"

#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>

#include <sstream>

namespace varimarch
{
namespace
{

std::string TextOf(vtkXMLDataElement* element)
{
  const char* text = element->GetCharacterData();
  return text ? text : "";
}

}

Plist::Plist(const std::string& path, const std::string& text)
  : path(path)
{
  VtkMessages messages;
  vtkNew<vtkXMLDataParser> parser;
  messages.Take(parser);
  parser->SetIgnoreCharacterData(0);
  std::istringstream stream(text);
  parser->SetStream(&stream);
  const bool isParsed = parser->Parse() != 0;
  vtkXMLDataElement* root = parser->GetRootElement();
  this->dictionary = isParsed && root ? root->FindNestedElementWithName("dict") : nullptr;
  if (!this->dictionary)
  {
    FailToRead(path, "a property list in XML", messages.FirstErrorOr("no dictionary"));
  }
}

Plist::Plist(const std::string& path, vtkSmartPointer<vtkXMLDataElement> dictionary)
  : path(path)
  , dictionary(dictionary)
{
}

vtkXMLDataElement* Plist::Value(const std::string& key) const
{
  for (int i = 0; i + 1 < this->dictionary->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* element = this->dictionary->GetNestedElement(i);
    if (std::string(element->GetName()) == "key" && TextOf(element) == key)
    {
      return this->dictionary->GetNestedElement(i + 1);
    }
  }
  return nullptr;
}

std::string Plist::Text(const std::string& key) const
{
  vtkXMLDataElement* value = this->Value(key);
  return value ? TextOf(value) : "";
}

std::vector<std::string> Plist::Texts(const std::string& key) const
{
  std::vector<std::string> texts;
  vtkXMLDataElement* value = this->Value(key);
  for (int i = 0; value && i < value->GetNumberOfNestedElements(); ++i)
  {
    texts.push_back(TextOf(value->GetNestedElement(i)));
  }
  return texts;
}

Plist Plist::Dictionary(const std::string& key) const
{
  vtkXMLDataElement* value = this->Value(key);
  if (!value || std::string(value->GetName()) != "dict")
  {
    FailToRead(this->path, "a property list with the dictionary " + Quoted(key), "none");
  }
  return Plist(this->path, value);
}

}
