#ifndef Varimarch_Readers_Parsing_XmlText_h
#define Varimarch_Readers_Parsing_XmlText_h

#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>

#include <string>

namespace varimarch
{

/// Parses XML and returns its root, with the text in elements.
/// @param path  path for the error message
/// @param what  name of the text for the error message
/// @throws std::runtime_error if it is not XML
vtkSmartPointer<vtkXMLDataElement> XmlFromText(
  const std::string& path, const std::string& what, const std::string& text);

}

#endif
