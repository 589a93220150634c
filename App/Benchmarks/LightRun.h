#ifndef Varimarch_Benchmarks_LightRun_h
#define Varimarch_Benchmarks_LightRun_h

#include "Commands.h"
#include "Machine.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>

namespace varimarch
{

/// How the measurements of a benchmark of light were made.
struct LightRun
{
  std::string commandText;
  Machine machine;
  LightCostOptions options;
};

LightRun LightRunOf(const LightCostArguments& arguments);

/// The beginning of a benchmark's JSON, to which its scenes are added.
nlohmann::ordered_json ToJson(const LightRun& run);

/// A benchmark whose files are written after each scene, so that an interrupted one has results.
struct SceneBySceneBench
{
  std::string name; ///< The name of its files, without extensions.
  std::function<void(const LoadedScene&, const OnStep&)> measure;
  std::function<nlohmann::ordered_json()> json;
  std::function<std::string()> markdown; ///< This is printed in the end, too.
  std::function<std::string()> csv = {}; ///< There is no such file if this is empty.
};

/// @throws std::runtime_error if a scene cannot be read or drawn, or a file cannot be written
void RunSceneByScene(const LightCostArguments& arguments, const SceneBySceneBench& bench);

}

#endif
