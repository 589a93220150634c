#include "Scene/Json/JsonCursor.h"

#include "Scene/Files/SmallFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace varimarch
{

namespace
{

// Our own files have six levels, and those of other programs few more.
constexpr int MostJsonLevels = 100;

// The value found, short enough for an error message.
std::string Excerpt(const nlohmann::json& value)
{
  if (value.is_object())
  {
    return "an object";
  }
  if (value.is_array())
  {
    return "an array of " + std::to_string(value.size());
  }
  const std::string text = value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

std::string Plain(double number)
{
  std::ostringstream stream;
  stream << number;
  return stream.str();
}

}

bool NumberRange::Contains(double value) const
{
  return std::isfinite(value) &&
    (this->excludesSmallest ? value > this->smallest : value >= this->smallest) &&
    (this->excludesLargest ? value < this->largest : value <= this->largest);
}

std::string NumberRange::Description() const
{
  std::string text = "a number";
  if (std::isfinite(this->smallest))
  {
    text += (this->excludesSmallest ? " > " : " >= ") + Plain(this->smallest);
  }
  if (std::isfinite(this->largest))
  {
    text += std::isfinite(this->smallest) ? " and" : "";
    text += (this->excludesLargest ? " < " : " <= ") + Plain(this->largest);
  }
  return text;
}

JsonCursor::JsonCursor(const nlohmann::json& value, std::string file, std::string path)
  : value(value)
  , file(std::move(file))
  , path(std::move(path))
{
}

void JsonCursor::Fail(const std::string& message) const
{
  throw std::runtime_error(
    this->file + ": " + (this->path.empty() ? "" : this->path + ": ") + message);
}

void JsonCursor::FailExpecting(const std::string& what) const
{
  this->Fail("expected " + what + ", found " + Excerpt(this->value));
}

double JsonCursor::Number(const NumberRange& range) const
{
  if (!this->value.is_number() || !range.Contains(this->value.get<double>()))
  {
    this->FailExpecting(range.Description());
  }
  return this->value.get<double>();
}

int JsonCursor::Integer(int smallest, int largest) const
{
  // Compare as double, so that an integer too large for int does not wrap around.
  const double number = this->value.is_number() ? this->value.get<double>() : std::nan("");
  if (!(number >= smallest && number <= largest) || number != std::floor(number))
  {
    this->FailExpecting(
      "a whole number from " + std::to_string(smallest) + " to " + std::to_string(largest));
  }
  return int(number);
}

bool JsonCursor::Boolean() const
{
  if (!this->IsBoolean())
  {
    this->FailExpecting("true or false");
  }
  return this->value.get<bool>();
}

bool JsonCursor::IsBoolean() const
{
  return this->value.is_boolean();
}

bool JsonCursor::IsText() const
{
  return this->value.is_string();
}

std::string JsonCursor::Text() const
{
  if (!this->value.is_string())
  {
    this->FailExpecting("a string");
  }
  return this->value.get<std::string>();
}

std::size_t JsonCursor::ChoiceIndex(const std::vector<std::string>& names) const
{
  const std::string word = this->Text();
  const auto found = std::find(names.begin(), names.end(), word);
  if (found == names.end())
  {
    this->Fail("unknown value \"" + word + "\"; " + Suggestion(word, names));
  }
  return std::size_t(found - names.begin());
}

void JsonCursor::RequireObject(const std::vector<std::string>& knownKeys) const
{
  if (!this->value.is_object())
  {
    this->FailExpecting("an object");
  }
  for (const auto& item : this->value.items())
  {
    if (std::find(knownKeys.begin(), knownKeys.end(), item.key()) == knownKeys.end())
    {
      this->Fail("unknown key \"" + item.key() + "\"; " + Suggestion(item.key(), knownKeys));
    }
  }
}

std::optional<JsonCursor> JsonCursor::Find(const std::string& key) const
{
  const auto found = this->value.find(key);
  if (found == this->value.end())
  {
    return std::nullopt;
  }
  return JsonCursor(*found, this->file, this->path.empty() ? key : this->path + "." + key);
}

JsonCursor JsonCursor::At(const std::string& key) const
{
  const std::optional<JsonCursor> member = this->Find(key);
  if (!member)
  {
    this->Fail("expected the key \"" + key + "\", found none");
  }
  return *member;
}

std::vector<JsonCursor> JsonCursor::Elements(std::size_t fewest, std::size_t most) const
{
  if (!this->value.is_array() || this->value.size() < fewest || this->value.size() > most)
  {
    const std::string upTo = fewest == most ? "" : " to " + std::to_string(most);
    this->FailExpecting("an array of " + std::to_string(fewest) + upTo);
  }
  std::vector<JsonCursor> elements;
  for (std::size_t i = 0; i < this->value.size(); ++i)
  {
    elements.emplace_back(this->value[i], this->file, this->path + "[" + std::to_string(i) + "]");
  }
  return elements;
}

nlohmann::json ParseJson(const std::string& text, const std::string& file)
{
  // Deeper values have no meaning here, and functions that visit them would use up the stack.
  const auto checkDepth = [&](int depth, nlohmann::json::parse_event_t, nlohmann::json&)
  {
    if (depth > MostJsonLevels)
    {
      throw std::runtime_error(file + ": expected JSON of at most " +
        std::to_string(MostJsonLevels) + " levels, found more");
    }
    return true;
  };
  try
  {
    return nlohmann::json::parse(text, checkDepth);
  }
  // A number that is too large is no error of parsing for the library.
  catch (const nlohmann::json::exception& error)
  {
    // Skip the library's own error number in brackets.
    const std::string what = error.what();
    throw std::runtime_error(file + ": not valid JSON: " + what.substr(what.find("] ") + 2));
  }
}

std::string TextFromJson(const nlohmann::ordered_json& json)
{
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

nlohmann::json ReadJson(const std::string& path)
{
  return ParseJson(BytesOfSmallFile(path), path);
}

}
