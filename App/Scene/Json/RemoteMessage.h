#ifndef Varimarch_Scene_RemoteMessage_h
#define Varimarch_Scene_RemoteMessage_h

#include "Scene/Model/Scene.h"

#include <optional>
#include <string>

namespace varimarch
{

// Messages between a viewer and a script that drives it. Each is one line of JSON, and each request
// has one answer:
//   {"get": "status"}   {"status": "empty"}, "loading", "shown" or "failed" with {"reason": "..."}
//   {"get": "look"}     {"look": {...}}
//   {"set": LOOK}       {"done": true}
// LOOK is an object as in Documentation/SceneFormat.md, or the name of a preset. A request that
// cannot be granted is answered by {"error": "one sentence"}.

/// The longest request [bytes].
constexpr int LongestRemoteMessage = 1 << 20;

struct RemoteRequest
{
  enum class Task
  {
    ReadStatus,
    ReadLook,
    SetLook,
  };
  Task task;
  Preset look = {}; ///< the look to set
};

/// @param text  a line without its end
/// @throws std::runtime_error with one sentence
RemoteRequest RemoteRequestFromText(const std::string& text);

/// The answers, without the ends of their lines.
std::string RemoteError(const std::string& sentence);
std::string RemoteStatus(const std::string& status, const std::string& reason = {});
std::string RemoteLook(const Preset& look);
std::string RemoteDone();

}

#endif
