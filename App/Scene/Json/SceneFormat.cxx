#include "Scene/Json/SceneFormat.h"

#include "Scene/Json/SceneFields.h"

#include <sstream>
#include <stdexcept>

namespace varimarch
{

namespace
{

const std::string RootName = "scene";
const std::string PresetLightName = "lighting";
const std::string DefinitionPrefix = "#/definitions/";

FormatDescription DescribedFormat()
{
  FormatDescription format;
  SceneFields().Describe(format);
  return format;
}

std::string WithoutCodeMarks(std::string text)
{
  text.erase(std::remove(text.begin(), text.end(), '`'), text.end());
  return text;
}

// The meaning with its unit, as in documents.
std::string MeaningOf(const FieldDescription& field)
{
  return field.meaning + (field.unit.empty() ? "" : " [" + field.unit + "]");
}

nlohmann::ordered_json SchemaOf(const StructDescription& one)
{
  nlohmann::ordered_json schema = { { "type", "object" }, { "additionalProperties", false } };
  for (const FieldDescription& field : one.fields)
  {
    if (field.isRequired)
    {
      schema["required"].push_back(field.key);
    }
  }
  for (const FieldDescription& field : one.fields)
  {
    nlohmann::ordered_json property;
    if (!field.meaning.empty())
    {
      property["description"] = WithoutCodeMarks(MeaningOf(field));
    }
    property.update(field.schema);
    schema["properties"][field.key] = property;
  }
  return schema;
}

std::string TableOf(const StructDescription& one)
{
  std::string table = "| key | meaning | default |\n|---|---|---|\n";
  for (const FieldDescription& field : one.fields)
  {
    if (!field.meaning.empty())
    {
      table += "| `" + field.key + "` | " + MeaningOf(field) + field.details + " | " +
        (field.isRequired ? "required" : field.usual) + " |\n";
    }
  }
  return table;
}

// The struct that a schema refers to, on its own or as the alternative to words; empty: none.
std::string StructOf(const nlohmann::ordered_json& schema)
{
  const nlohmann::ordered_json& last = schema.contains("oneOf") ? schema["oneOf"].back() : schema;
  return last.contains("$ref") ? last["$ref"].get<std::string>().substr(DefinitionPrefix.size())
                               : std::string();
}

void AddSettingsOf(const FormatDescription& format, const std::string& name,
  std::vector<std::string> path, std::vector<SceneSetting>& settings)
{
  for (const FieldDescription& field : format.At(name).fields)
  {
    path.push_back(field.key);
    const std::string nested = StructOf(field.schema);
    if (!field.option.empty())
    {
      settings.push_back({ path, field });
    }
    // The light of a preset is not the scene's until the scene takes it.
    else if (format.HasStruct(nested) && nested != PresetLightName)
    {
      AddSettingsOf(format, nested, path, settings);
    }
    path.pop_back();
  }
}

}

std::string SceneSetting::Pointer() const
{
  std::string pointer;
  for (const std::string& key : this->path)
  {
    pointer += "/" + key;
  }
  return pointer;
}

std::string SceneSchemaText()
{
  const FormatDescription format = DescribedFormat();
  nlohmann::ordered_json schema = { { "$schema", "http://json-schema.org/draft-07/schema#" },
    { "title", "Varimarch scene" },
    { "description",
      "Everything that an image of a volume depends on; see Documentation/SceneFormat.md." } };
  for (const auto& [name, value] : format.values)
  {
    schema["definitions"][name] = value;
  }
  for (const StructDescription& one : format.structs)
  {
    if (one.name != RootName)
    {
      schema["definitions"][one.name] = SchemaOf(one);
    }
  }
  schema.update(SchemaOf(format.At(RootName)));
  return schema.dump(1) + "\n";
}

std::string WithFieldTables(const std::string& markdown)
{
  const std::string begin = "<!-- fields: ";
  const std::string end = "<!-- end -->";
  const FormatDescription format = DescribedFormat();
  std::istringstream lines(markdown);
  std::string result;
  std::string inside; // the struct whose old table is skipped
  for (std::string line; std::getline(lines, line);)
  {
    if (line.rfind(begin, 0) == 0)
    {
      inside = line.substr(begin.size(), line.find(" -->") - begin.size());
      if (!format.HasStruct(inside))
      {
        throw std::runtime_error("SceneFormat.md: no struct is called \"" + inside + "\"");
      }
      result += line + "\n" + TableOf(format.At(inside));
    }
    inside = line == end ? "" : inside;
    result += inside.empty() ? line + "\n" : "";
  }
  if (!inside.empty())
  {
    throw std::runtime_error("SceneFormat.md: expected \"" + end + "\" after the table of \"" +
      inside + "\", found the end of the file");
  }
  return result;
}

std::vector<SceneSetting> SceneSettings()
{
  const FormatDescription format = DescribedFormat();
  std::vector<SceneSetting> settings;
  AddSettingsOf(format, RootName, {}, settings);
  return settings;
}

}
