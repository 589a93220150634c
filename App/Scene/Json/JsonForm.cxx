#include "Scene/Json/JsonForm.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

namespace varimarch
{

namespace
{

// A limit as people write it: whole numbers without a fraction.
nlohmann::ordered_json Limit(double number)
{
  return number == std::floor(number) ? nlohmann::ordered_json(std::int64_t(number))
                                      : nlohmann::ordered_json(number);
}

}

bool FormatDescription::HasStruct(const std::string& name) const
{
  return std::any_of(this->structs.begin(), this->structs.end(),
    [&](const StructDescription& one) { return one.name == name; });
}

bool FormatDescription::HasValue(const std::string& name) const
{
  return std::any_of(
    this->values.begin(), this->values.end(), [&](const auto& one) { return one.first == name; });
}

const StructDescription& FormatDescription::At(const std::string& name) const
{
  return *std::find_if(this->structs.begin(), this->structs.end(),
    [&](const StructDescription& one) { return one.name == name; });
}

StructDescription& FormatDescription::At(const std::string& name)
{
  return const_cast<StructDescription&>(std::as_const(*this).At(name));
}

nlohmann::ordered_json SchemaOf(const NumberRange& range)
{
  nlohmann::ordered_json schema = { { "type", "number" } };
  if (std::isfinite(range.smallest))
  {
    schema[range.excludesSmallest ? "exclusiveMinimum" : "minimum"] = Limit(range.smallest);
  }
  if (std::isfinite(range.largest))
  {
    schema[range.excludesLargest ? "exclusiveMaximum" : "maximum"] = Limit(range.largest);
  }
  return schema;
}

nlohmann::ordered_json SchemaOfArray(
  const nlohmann::ordered_json& items, std::size_t fewest, std::size_t most)
{
  nlohmann::ordered_json schema = { { "type", "array" }, { "items", items } };
  if (fewest > 0)
  {
    schema["minItems"] = fewest;
  }
  schema["maxItems"] = most;
  return schema;
}

nlohmann::ordered_json SchemaOfInteger(int smallest, int largest)
{
  return { { "type", "integer" }, { "minimum", smallest }, { "maximum", largest } };
}

nlohmann::ordered_json SchemaOfReference(const std::string& name)
{
  return { { "$ref", "#/definitions/" + name } };
}

std::string UsualText(const nlohmann::ordered_json& value)
{
  if (value.is_number())
  {
    std::ostringstream text;
    text << value.get<double>();
    return text.str();
  }
  if (value.empty() || value == "")
  {
    return value == "" ? "empty" : "none";
  }
  std::string code = value.is_string() ? value.get<std::string>() : value.dump();
  // Whole numbers are written as such, and with a space after each comma.
  for (std::size_t at = code.find(".0"); at != std::string::npos; at = code.find(".0", at))
  {
    at + 2 == code.size() || !std::isdigit(static_cast<unsigned char>(code[at + 2]))
      ? (void)code.erase(at, 2)
      : (void)++at;
  }
  for (std::size_t at = code.find(','); at != std::string::npos; at = code.find(',', at + 1))
  {
    code.insert(at + 1, " ");
  }
  return "`" + code + "`";
}

JsonForm<double> NumberForm(const NumberRange& range)
{
  return { [=](const JsonCursor& json, double& value) { value = json.Number(range); },
    [](const double& value) { return nlohmann::ordered_json(value); },
    [=](FormatDescription&) { return SchemaOf(range); } };
}

JsonForm<bool> BooleanForm()
{
  return { [](const JsonCursor& json, bool& value) { value = json.Boolean(); },
    [](const bool& value) { return nlohmann::ordered_json(value); },
    [](FormatDescription&) {
      return nlohmann::ordered_json{ { "type", "boolean" } };
    } };
}

JsonForm<std::string> TextForm()
{
  return { [](const JsonCursor& json, std::string& value) { value = json.Text(); },
    [](const std::string& value) { return nlohmann::ordered_json(value); },
    [](FormatDescription&) {
      return nlohmann::ordered_json{ { "type", "string" } };
    } };
}

JsonForm<glm::dvec3> ColorForm()
{
  return { [](const JsonCursor& json, glm::dvec3& value)
    {
      const std::array<double, 3> rgb = json.Numbers<3>(UnitInterval);
      value = { rgb[0], rgb[1], rgb[2] };
    },
    [](const glm::dvec3& value) {
      return nlohmann::ordered_json{ value.r, value.g, value.b };
    },
    [](FormatDescription&) { return SchemaOfArray(SchemaOf(UnitInterval), 3, 3); } };
}

JsonForm<std::string> WordForm(const std::vector<std::string>& words)
{
  NameTable<std::string> table;
  for (const std::string& word : words)
  {
    table.emplace_back(word, word);
  }
  return { [=](const JsonCursor& json, std::string& value) { value = json.Choice(table); },
    [](const std::string& value) { return nlohmann::ordered_json(value); },
    [=](FormatDescription&) {
      return nlohmann::ordered_json{ { "enum", words } };
    } };
}

JsonForm<std::optional<double>> NumberOrAutoForm(const NumberRange& range)
{
  return { [=](const JsonCursor& json, std::optional<double>& value)
    {
      if (json.IsText() && json.Text() != "auto")
      {
        json.FailExpecting(range.Description() + " or \"auto\"");
      }
      value = json.IsText() ? std::nullopt : std::optional(json.Number(range));
    },
    [](const std::optional<double>& value)
    { return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json("auto"); },
    [=](FormatDescription&)
    {
      return nlohmann::ordered_json{ { "oneOf",
        { SchemaOf(range), nlohmann::ordered_json{ { "const", "auto" } } } } };
    } };
}

}
