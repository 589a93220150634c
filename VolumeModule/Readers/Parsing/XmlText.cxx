#include "Readers/Parsing/XmlText.h"

#include "Readers/FileError.h"
#include "Readers/Parsing/Nesting.h"
#include "Readers/Parsing/VtkMessages.h"

#include <vtkNew.h>
#include <vtkXMLDataParser.h>

#include <sstream>

namespace varimarch
{

vtkSmartPointer<vtkXMLDataElement> XmlFromText(
  const std::string& path, const std::string& what, const std::string& text)
{
  if (MayBeNestedTooDeep(text))
  {
    FailToRead(path, "XML of at most " + std::to_string(MostNestedElements) + " elements", "more");
  }
  VtkMessages messages;
  vtkNew<vtkXMLDataParser> parser;
  messages.Observe(parser);
  parser->SetIgnoreCharacterData(0);
  std::istringstream stream(text);
  parser->SetStream(&stream);
  const bool isParsed = parser->Parse() != 0;
  if (!isParsed || !parser->GetRootElement())
  {
    FailToRead(path, what, messages.FirstErrorOr("no element"));
  }
  return parser->GetRootElement();
}

}
