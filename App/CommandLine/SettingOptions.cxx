#include "SettingOptions.h"

#include "ArgumentChecks.h"
#include "Parser.h"
#include "Scene/Json/JsonCursor.h"
#include "Scene/Json/SceneFormat.h"
#include "Scene/Model/SceneLights.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

namespace varimarch
{

namespace
{

using Json = nlohmann::ordered_json;

// Groups in the help.
constexpr const char* LookGroup = "Look";
constexpr const char* ImageGroup = "Image";
constexpr const char* SamplingGroup = "Sampling";

std::string GroupOf(const SceneSetting& setting)
{
  const std::string& key = setting.path.front();
  if (key == "render")
  {
    return SamplingGroup;
  }
  return key == "camera" || key == "cuts" || key == "size" || key == "background" ? ImageGroup
                                                                                  : LookGroup;
}

// Lines that fit beside the names of the options.
std::string Wrapped(const std::string& text)
{
  constexpr std::size_t Width = 82;
  std::istringstream words(text);
  std::string lines;
  std::size_t used = 0;
  for (std::string word; words >> word;)
  {
    const bool fits = used + 1 + word.size() <= Width;
    lines += used == 0 ? word : (fits ? " " : "\n") + word;
    used = used > 0 && fits ? used + 1 + word.size() : word.size();
  }
  return lines;
}

// The sentence of a field: what it means, its unit and its default.
std::string HelpOf(const FieldDescription& field)
{
  std::string text = field.meaning + (field.unit.empty() ? "" : ", " + field.unit);
  if (field.schema.value("type", "") != "boolean")
  {
    text += " (default: " + field.usual + ")";
  }
  text.erase(std::remove(text.begin(), text.end(), '`'), text.end());
  text.front() = char(std::toupper(static_cast<unsigned char>(text.front())));
  return Wrapped(text);
}

NumberRange RangeOf(const Json& schema)
{
  NumberRange range;
  range.excludesSmallest = schema.contains("exclusiveMinimum");
  range.excludesLargest = schema.contains("exclusiveMaximum");
  range.smallest =
    schema.value(range.excludesSmallest ? "exclusiveMinimum" : "minimum", range.smallest);
  range.largest =
    schema.value(range.excludesLargest ? "exclusiveMaximum" : "maximum", range.largest);
  return range;
}

CLI::Validator IsIn(const NumberRange& range)
{
  const auto check = [range](std::string& text)
  {
    double number = 0.0;
    const bool good = CLI::detail::lexical_cast(text, number) && range.Contains(number);
    return good ? std::string() : "expected " + range.Description() + ", found \"" + text + "\"";
  };
  return CLI::Validator(check, "");
}

CLI::Validator CheckOf(const Json& schema)
{
  if (schema["type"] == "integer")
  {
    return CLI::Range(schema["minimum"].get<int>(), schema["maximum"].get<int>()).description("");
  }
  const NumberRange range = RangeOf(schema);
  // CLI11's own message suits ranges with two ends that count.
  const bool isClosed = !range.excludesSmallest && !range.excludesLargest &&
    std::isfinite(range.smallest) && std::isfinite(range.largest);
  return isClosed ? CLI::Range(range.smallest, range.largest).description("") : IsIn(range);
}

// The option of a setting of one number or word.
CLI::Option* AddValue(CLI::App& command, const SceneSetting& setting, Json& value)
{
  const FieldDescription& field = setting.field;
  // A field may also be "auto", which options do not offer, since it is what scenes have.
  const Json schema = field.schema.contains("oneOf")
    ? *std::find_if(field.schema["oneOf"].begin(), field.schema["oneOf"].end(),
        [](const Json& one) { return one.value("type", "") == "number"; })
    : field.schema;
  const std::string help = HelpOf(field);
  if (schema.contains("enum"))
  {
    auto words = schema["enum"].get<std::vector<std::string>>();
    words.erase(std::remove(words.begin(), words.end(), "auto"), words.end());
    return command
      .add_option_function<std::string>(
        field.option, [&value](const std::string& word) { value = word; }, help)
      ->check(OneOf(words));
  }
  if (schema["type"] == "integer")
  {
    return command
      .add_option_function<int>(
        field.option, [&value](const int& number) { value = number; }, help)
      ->check(CheckOf(schema));
  }
  return command
    .add_option_function<double>(
      field.option, [&value](const double& number) { value = number; }, help)
    ->check(CheckOf(schema));
}

// The option of a setting of several numbers: "640x480" for whole ones, else "1,0.5,0".
CLI::Option* AddNumbers(CLI::App& command, const SceneSetting& setting, Json& value)
{
  const FieldDescription& field = setting.field;
  const Json& items = field.schema["items"];
  if (items["type"] == "integer")
  {
    const int smallest = items["minimum"].get<int>();
    const int largest = items["maximum"].get<int>();
    const auto check = [=](std::string& text)
    { return SidesProblem<2>(text, "800x600", smallest, largest); };
    return command
      .add_option_function<std::string>(
        field.option,
        [=, &value](const std::string& text) { value = *Sides<2>(text, smallest, largest); },
        HelpOf(field))
      ->check(CLI::Validator(check, ""));
  }
  return command
    .add_option_function<std::vector<double>>(
      field.option, [&value](const std::vector<double>& numbers) { value = numbers; },
      HelpOf(field))
    ->check(CheckOf(items))
    ->delimiter(',')
    ->expected(field.schema["minItems"].get<int>());
}

CLI::Option* AddSetting(CLI::App& command, const SceneSetting& setting, Json& value)
{
  const std::string type = setting.field.schema.value("type", "");
  if (type == "boolean")
  {
    return command.add_flag_callback(
      setting.field.option, [&value] { value = true; }, HelpOf(setting.field));
  }
  CLI::Option* const option =
    type == "array" ? AddNumbers(command, setting, value) : AddValue(command, setting, value);
  return setting.field.optionValue.empty() ? option : option->type_name(setting.field.optionValue);
}

void AddSettings(CLI::App& command, SceneArguments& arguments, const std::string& group)
{
  for (const SceneSetting& setting : SceneSettings())
  {
    if (GroupOf(setting) == group)
    {
      AddSetting(command, setting, arguments.settings[setting.Pointer()])->group(group);
    }
  }
}

void AddLights(CLI::App& command, SceneArguments& arguments)
{
  const auto setLights = [&](const std::vector<std::pair<double, double>>& angles)
  {
    for (const auto& [azimuth, elevation] : angles)
    {
      arguments.lights.push_back(CameraLight(azimuth, elevation));
    }
  };
  command
    .add_option_function<std::vector<std::pair<double, double>>>("--light", setLights,
      "A light this far to the right of and above the eye, degrees; may be repeated\n"
      "(default: at the eye). Scenes have more kinds of lights")
    ->check(CLI::Range(-180.0, 180.0).description(""))
    ->delimiter(',')
    ->type_name("AZ,EL")
    ->group(LookGroup);
  command
    .add_flag("--preset-light", arguments.presetLight,
      "Light the volume in the light that suits its preset; the options of light change it")
    ->group(LookGroup);
  command
    .add_option("--softness", arguments.softnessDegrees,
      "Softness of the shadows of all lights that are not at the eye: half the angle of the\n"
      "cones that they come from, degrees, 0 to 60 (default: the scene's)")
    ->check(CLI::Range(0.0, LargestSoftnessDegrees).description(""))
    ->type_name("DEG")
    ->group(LookGroup);
}

// Adds a flag that is another way to say a setting.
CLI::Option* AddFlag(CLI::App& command, const std::string& option, Json& value, const Json& meant,
  const std::string& help)
{
  return command.add_flag_callback(
    option, [&value, meant] { value = meant; }, help);
}

}

void AddLookSettings(CLI::App& command, SceneArguments& arguments)
{
  Json& shading = arguments.settings["/look/shading/enabled"];
  CLI::Option* const shade = AddFlag(command, "--shade", shading, true, "Shade the volume");
  shade->group(LookGroup);
  AddFlag(command, "--no-shade", shading, false, "Do not shade the volume")
    ->excludes(shade)
    ->group(LookGroup);
  AddLights(command, arguments);
  AddFlag(command, "--shadows", arguments.settings["/shadows"], true,
    "Let the volume cast shadows, from lights that are not at the eye; takes about\n"
    "three times as long")
    ->group(LookGroup);
  AddSettings(command, arguments, LookGroup);
}

void AddImageSettings(CLI::App& command, SceneArguments& arguments)
{
  AddSettings(command, arguments, ImageGroup);
  AddFlag(command, "--parallel", arguments.settings["/camera/projection"], "parallel",
    "Parallel instead of perspective projection")
    ->group(ImageGroup);
}

void AddSamplingSettings(CLI::App& command, SceneArguments& arguments)
{
  AddSettings(command, arguments, SamplingGroup);
  command.get_option("--sample-distance-voxels")->excludes("--sample-distance");
}

}
