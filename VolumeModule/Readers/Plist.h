#ifndef Varimarch_Readers_Plist_h
#define Varimarch_Readers_Plist_h

#include <memory>
#include <string>
#include <vector>

namespace varimarch
{

/// A dictionary, with keys and values, of an Apple property list in XML or binary.
class Plist
{
public:
  /// Parses a property list whose root is a dictionary.
  /// @param path  path for error messages
  /// @throws std::runtime_error if it is not one
  Plist(const std::string& path, const std::string& bytes);

  /// Text of a value that is a string or a number; empty if the key does not exist.
  std::string Text(const std::string& key) const;

  /// Texts of the values of an array; empty if the key does not exist.
  std::vector<std::string> Texts(const std::string& key) const;

  /// The dictionary with the given key.
  /// @throws std::runtime_error if there is none
  Plist Dictionary(const std::string& key) const;

private:
  using Node = void*; ///< libplist's plist_t

  Plist(const std::string& path, std::shared_ptr<void> root, Node dictionary);
  Node Value(const std::string& key) const;

  std::string path;
  std::shared_ptr<void> root; ///< owner of all nodes
  Node dictionary;
};

}

#endif
