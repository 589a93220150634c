#ifndef Varimarch_Scene_JsonCursor_h
#define Varimarch_Scene_JsonCursor_h

#include "Scene/Json/SceneNames.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// The numbers that a key of a file accepts.
struct NumberRange
{
  double smallest = -std::numeric_limits<double>::infinity();
  double largest = std::numeric_limits<double>::infinity();
  bool excludesSmallest = false;
  bool excludesLargest = false;

  bool Contains(double value) const;
  std::string Description() const; ///< "a number > 0"
};

inline constexpr NumberRange UnitInterval = { 0.0, 1.0 };
inline constexpr NumberRange Positive = { 0.0, std::numeric_limits<double>::infinity(), true };

/// A JSON value and its path in the file, so that every error names both:
/// `head.json: camera.zoom: expected a number > 0, found "big"`. Every reading function throws such
/// a std::runtime_error if the value is not of the expected kind. Holds a reference to the JSON
/// value, which must outlive the cursor.
class JsonCursor
{
public:
  JsonCursor(const nlohmann::json& value, std::string file, std::string path = {});

  double Number(const NumberRange& range = {}) const;
  int Integer(int smallest, int largest) const;
  bool Boolean() const;
  bool IsBoolean() const;
  std::string Text() const;
  bool IsText() const;

  /// The enumerator that the word in the file stands for.
  template <class Value>
  Value Choice(const NameTable<Value>& table) const
  {
    return table[this->ChoiceIndex(NamesOf(table))].second;
  }

  /// Requires an object that has no keys other than these.
  void RequireObject(const std::vector<std::string>& knownKeys) const;

  /// The value under a key. Requires an object.
  std::optional<JsonCursor> Find(const std::string& key) const;
  JsonCursor At(const std::string& key) const;

  /// The elements of an array of fewest to most elements.
  std::vector<JsonCursor> Elements(std::size_t fewest, std::size_t most) const;

  template <std::size_t count>
  std::array<double, count> Numbers(const NumberRange& range = {}) const
  {
    std::array<double, count> numbers;
    const std::vector<JsonCursor> elements = this->Elements(count, count);
    for (std::size_t i = 0; i < count; ++i)
    {
      numbers[i] = elements[i].Number(range);
    }
    return numbers;
  }

  template <std::size_t count>
  std::array<int, count> Integers(int smallest, int largest) const
  {
    std::array<int, count> numbers;
    const std::vector<JsonCursor> elements = this->Elements(count, count);
    for (std::size_t i = 0; i < count; ++i)
    {
      numbers[i] = elements[i].Integer(smallest, largest);
    }
    return numbers;
  }

  /// Throws "file: path: expected <what>, found <this value>".
  [[noreturn]] void FailExpecting(const std::string& what) const;
  /// Throws "file: path: <message>".
  [[noreturn]] void Fail(const std::string& message) const;

private:
  std::size_t ChoiceIndex(const std::vector<std::string>& names) const;

  const nlohmann::json& value;
  std::string file;
  std::string path;
};

/// Reads and parses a file. @throws std::runtime_error that names the file
nlohmann::json ReadJson(const std::string& path);

/// Parses a text; `file` is its name in errors. @throws std::runtime_error
nlohmann::json ParseJson(const std::string& text, const std::string& file);

/// Indented text that ends with a line break. Bytes that are not valid UTF-8, which a path may
/// contain, become the replacement character.
std::string TextFromJson(const nlohmann::ordered_json& json);

}

#endif
