#ifndef Varimarch_Readers_Plist_h
#define Varimarch_Readers_Plist_h

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkXMLDataElement;

namespace varimarch
{

/// A dictionary of an Apple property list in XML: keys and their values.
class Plist
{
public:
  /// Parses a property list whose top is a dictionary.
  /// @param path  for error messages
  /// @throws std::runtime_error when it is none
  Plist(const std::string& path, const std::string& text);

  /// The text of a value that is a string or a number; empty if there is no such key.
  std::string Text(const std::string& key) const;

  /// The texts of the values of an array; empty if there is no such key.
  std::vector<std::string> Texts(const std::string& key) const;

  /// The dictionary under a key.
  /// @throws std::runtime_error if there is none
  Plist Dictionary(const std::string& key) const;

private:
  Plist(const std::string& path, vtkSmartPointer<vtkXMLDataElement> dictionary);
  vtkXMLDataElement* Value(const std::string& key) const;

  std::string path;
  vtkSmartPointer<vtkXMLDataElement> dictionary;
};

}

#endif
