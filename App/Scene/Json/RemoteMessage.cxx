#include "Scene/Json/RemoteMessage.h"

#include "Scene/Json/JsonCursor.h"
#include "Scene/Json/SceneFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>

namespace varimarch
{

namespace
{

// A request's deepest values are the numbers of colours in nodes.
constexpr int DeepestMessage = 8;

// The depth of brackets outside of strings, which may be wrong for text that is not JSON.
int DepthOf(const std::string& text)
{
  int depth = 0;
  int deepest = 0;
  bool inString = false;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const char letter = text[i];
    if (inString && letter == '\\')
    {
      ++i;
    }
    else if (letter == '"')
    {
      inString = !inString;
    }
    else if (!inString)
    {
      depth += letter == '[' || letter == '{' ? 1 : letter == ']' || letter == '}' ? -1 : 0;
      deepest = std::max(deepest, depth);
    }
  }
  return deepest;
}

std::string LineOf(const nlohmann::ordered_json& json)
{
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}

RemoteRequest RemoteRequestFromText(const std::string& text)
{
  if (text.size() > std::size_t(LongestRemoteMessage))
  {
    throw std::runtime_error(
      "message: expected at most " + std::to_string(LongestRemoteMessage) + " bytes, found more");
  }
  if (DepthOf(text) > DeepestMessage)
  {
    throw std::runtime_error("message: expected at most " + std::to_string(DeepestMessage) +
      " levels of brackets, found more");
  }
  const nlohmann::json parsed = ParseJson(text, "message");
  const JsonCursor json(parsed, "message");
  json.RequireObject({ "get", "set" });
  if (const auto look = json.Find("set"))
  {
    return { RemoteRequest::Task::SetLook, PresetFromJson(*look) };
  }
  static const NameTable<RemoteRequest::Task> readable = {
    { "status", RemoteRequest::Task::ReadStatus }, { "look", RemoteRequest::Task::ReadLook }
  };
  return { json.At("get").Choice(readable) };
}

std::string RemoteError(const std::string& sentence)
{
  return LineOf({ { "error", sentence } });
}

std::string RemoteStatus(const std::string& status, const std::string& reason)
{
  nlohmann::ordered_json json = { { "status", status } };
  if (!reason.empty())
  {
    json["reason"] = reason;
  }
  return LineOf(json);
}

std::string RemoteLook(const Preset& look)
{
  return LineOf({ { "look", JsonFromPreset(look) } });
}

std::string RemoteDone()
{
  return LineOf({ { "done", true } });
}

}
