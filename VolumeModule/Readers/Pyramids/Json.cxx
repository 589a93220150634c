#include "Readers/Pyramids/Json.h"

#include "Readers/FileError.h"
#include "Readers/Parsing/HeaderText.h"
#include "Readers/VoxelLayout.h"

#include <algorithm>

namespace varimarch
{

nlohmann::json JsonObjectOf(const std::string& path)
{
  // No description is longer; a parsed one takes many times the memory of its text.
  constexpr double MostBytes = 64e6;
  const double bytes = double(ReadableFileSize(path));
  if (bytes > MostBytes)
  {
    FailToRead(path, "JSON of at most " + ByteText(MostBytes), ByteText(bytes));
  }
  const std::string text = WholeFile(path);
  nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object())
  {
    FailToRead(
      path, "a JSON object", text.empty() ? "an empty file" : "text such as " + Quoted(text));
  }
  return json;
}

const nlohmann::json& ValueAt(const nlohmann::json& object, const char* key)
{
  static const nlohmann::json none;
  const auto value = object.is_object() ? object.find(key) : object.end();
  return object.is_object() && value != object.end() ? *value : none;
}

std::string TextIn(const nlohmann::json& value)
{
  return value.is_string() ? value.get<std::string>() : std::string();
}

std::vector<nlohmann::json> ListIn(const nlohmann::json& value)
{
  return value.is_array() ? value.get<std::vector<nlohmann::json>>()
                          : std::vector<nlohmann::json>();
}

std::vector<double> NumbersIn(const nlohmann::json& value)
{
  const bool areNumbers = value.is_array() &&
    std::all_of(value.begin(), value.end(), [](const auto& entry) { return entry.is_number(); });
  return areNumbers ? value.get<std::vector<double>>() : std::vector<double>();
}

}
