#ifndef Varimarch_Scene_LookXml_h
#define Varimarch_Scene_LookXml_h

#include <vtkNew.h>

#include <string>
#include <vector>

class vtkXMLDataElement;
class vtkXMLDataParser;

namespace varimarch
{

/// A parsed XML text, which owns its elements.
class LookXml
{
public:
  /// @param file  name of the file in errors
  /// @throws std::runtime_error with one sentence if the text is not valid XML
  LookXml(const std::string& text, const std::string& file);
  ~LookXml();
  LookXml(const LookXml&) = delete;
  void operator=(const LookXml&) = delete;

  vtkXMLDataElement* Root() const;

private:
  vtkNew<vtkXMLDataParser> parser;
};

/// Elements of a name at any depth, including the top. The name is in lower case; the case of the
/// elements' names does not matter.
std::vector<vtkXMLDataElement*> ElementsNamed(vtkXMLDataElement* top, const std::string& name);

}

#endif
