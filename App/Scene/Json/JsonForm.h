#ifndef Varimarch_Scene_JsonForm_h
#define Varimarch_Scene_JsonForm_h

#include "Scene/Json/JsonCursor.h"

#include <nlohmann/json.hpp>

#include <glm/vec3.hpp>

#include <functional>
#include <limits>
#include <utility>

namespace varimarch
{

/// The description of a field of a struct: the source of the schema, of the tables in
/// Documentation/SceneFormat.md, of the options of the command line and of Python's checks.
struct FieldDescription
{
  std::string key;
  std::string meaning; ///< a phrase that may begin a sentence once its first letter is a capital
  std::string unit;    ///< empty: none
  std::string usual;   ///< the default in words
  std::string details; ///< goes on after the meaning, in documents only
  bool isRequired = false;
  std::string option;      ///< the option of the command line, such as "--zoom"; empty: none
  std::string optionValue; ///< placeholder of its value in the help
  bool isArgument = false; ///< true: an argument of Python's render(), named after the option
  nlohmann::ordered_json schema;
};

struct StructDescription
{
  std::string name;
  std::vector<FieldDescription> fields;
};

/// All structs of a format, each once, in the order in which their descriptions begin.
class FormatDescription
{
public:
  bool HasStruct(const std::string& name) const;
  bool HasValue(const std::string& name) const;
  /// The struct of this name, which must be here.
  StructDescription& At(const std::string& name);
  const StructDescription& At(const std::string& name) const;
  void Add(const std::string& name) { this->structs.push_back({ name, {} }); }

  std::vector<StructDescription> structs;
  /// Schemas of values that are no struct but have a name, such as a choice between structs.
  std::vector<std::pair<std::string, nlohmann::ordered_json>> values;
};

/// The form of a value in JSON. `read` throws a std::runtime_error that names file and path, and
/// leaves alone what an object does not mention. `describe` returns the schema, and adds the
/// structs that the schema refers to.
template <class Value>
struct JsonForm
{
  std::function<void(const JsonCursor&, Value&)> read;
  std::function<nlohmann::ordered_json(const Value&)> write;
  std::function<nlohmann::ordered_json(FormatDescription&)> describe;
};

nlohmann::ordered_json SchemaOf(const NumberRange& range);
nlohmann::ordered_json SchemaOfArray(
  const nlohmann::ordered_json& items, std::size_t fewest, std::size_t most);
nlohmann::ordered_json SchemaOfInteger(int smallest, int largest);
/// A default as documents tell it: a number as it is, all else as code.
std::string UsualText(const nlohmann::ordered_json& value);
/// The schema that refers to a struct or value by its name.
nlohmann::ordered_json SchemaOfReference(const std::string& name);

JsonForm<double> NumberForm(const NumberRange& range = {});
JsonForm<bool> BooleanForm();
JsonForm<std::string> TextForm();
JsonForm<glm::dvec3> ColorForm();
/// One of these words, which the value keeps as it is.
JsonForm<std::string> WordForm(const std::vector<std::string>& words);
/// A number, or the word "auto" for an empty value.
JsonForm<std::optional<double>> NumberOrAutoForm(const NumberRange& range);

template <class Integer = int>
JsonForm<Integer> IntegerForm(int smallest, int largest = std::numeric_limits<int>::max())
{
  return { [=](const JsonCursor& json, Integer& value)
    { value = Integer(json.Integer(smallest, largest)); },
    [](const Integer& value) { return nlohmann::ordered_json(value); },
    [=](FormatDescription&) { return SchemaOfInteger(smallest, largest); } };
}

template <std::size_t count>
JsonForm<std::array<double, count>> NumbersForm(const NumberRange& range = {})
{
  return { [=](const JsonCursor& json, std::array<double, count>& value)
    { value = json.Numbers<count>(range); },
    [](const std::array<double, count>& value) { return nlohmann::ordered_json(value); },
    [=](FormatDescription&) { return SchemaOfArray(SchemaOf(range), count, count); } };
}

template <std::size_t count>
JsonForm<std::array<int, count>> IntegersForm(int smallest, int largest)
{
  return { [=](const JsonCursor& json, std::array<int, count>& value)
    { value = json.Integers<count>(smallest, largest); },
    [](const std::array<int, count>& value) { return nlohmann::ordered_json(value); },
    [=](FormatDescription&)
    { return SchemaOfArray(SchemaOfInteger(smallest, largest), count, count); } };
}

/// A word that stands for a value; the table must outlive the form.
template <class Value>
JsonForm<Value> ChoiceForm(const NameTable<Value>& table)
{
  return { [&table](const JsonCursor& json, Value& value) { value = json.Choice(table); },
    [&table](const Value& value) { return nlohmann::ordered_json(NameOf(table, value)); },
    [&table](FormatDescription&) {
      return nlohmann::ordered_json{ { "enum", NamesOf(table) } };
    } };
}

/// The same, or the word "auto" for an empty value.
template <class Value>
JsonForm<std::optional<Value>> ChoiceOrAutoForm(const NameTable<Value>& table)
{
  return { [&table](const JsonCursor& json, std::optional<Value>& value)
    {
      value =
        json.IsText() && json.Text() == "auto" ? std::nullopt : std::optional(json.Choice(table));
    },
    [&table](const std::optional<Value>& value)
    { return nlohmann::ordered_json(value ? NameOf(table, *value) : "auto"); },
    [&table](FormatDescription&)
    {
      std::vector<std::string> words = NamesOf(table);
      words.insert(words.begin(), "auto");
      return nlohmann::ordered_json{ { "enum", words } };
    } };
}

/// A value that must have a property besides its form; the message says which.
template <class Value>
JsonForm<Value> Checked(
  JsonForm<Value> form, bool (*isGood)(const Value&), const std::string& message)
{
  const auto read = form.read;
  form.read = [=](const JsonCursor& json, Value& value)
  {
    read(json, value);
    if (!isGood(value))
    {
      json.Fail(message);
    }
  };
  return form;
}

/// An array. `checkLast`, if not null, may throw for the last of the elements that have been read.
template <class Value>
JsonForm<std::vector<Value>> ListForm(const JsonForm<Value>& element, std::size_t fewest,
  std::size_t most, void (*checkLast)(const JsonCursor&, const std::vector<Value>&) = nullptr)
{
  return { [=](const JsonCursor& json, std::vector<Value>& values)
    {
      values.clear();
      for (const JsonCursor& one : json.Elements(fewest, most))
      {
        element.read(one, values.emplace_back(Value{}));
        if (checkLast)
        {
          checkLast(one, values);
        }
      }
    },
    [=](const std::vector<Value>& values)
    {
      nlohmann::ordered_json json = nlohmann::ordered_json::array();
      for (const Value& value : values)
      {
        json.push_back(element.write(value));
      }
      return json;
    },
    [=](FormatDescription& format)
    { return SchemaOfArray(element.describe(format), fewest, most); } };
}

/// A form with a name of its own in the schema.
template <class Value>
JsonForm<Value> NamedForm(const std::string& name, JsonForm<Value> form)
{
  const auto describe = form.describe;
  form.describe = [=](FormatDescription& format)
  {
    if (!format.HasValue(name))
    {
      const nlohmann::ordered_json schema = describe(format);
      format.values.emplace_back(name, schema);
    }
    return SchemaOfReference(name);
  };
  return form;
}

}

#endif
