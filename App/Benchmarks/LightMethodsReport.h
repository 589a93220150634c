#ifndef Varimarch_Benchmarks_LightMethodsReport_h
#define Varimarch_Benchmarks_LightMethodsReport_h

#include "LightMethodsBench.h"
#include "LightRun.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace varimarch
{

/// The measurements of `varimarch-bench light-methods`.
struct LightMethodsPage
{
  LightRun run;
  std::vector<LightMethodsCase> cases; ///< at least one
};

/// A table of all scenes together, and one with error and time of each scene.
std::string MarkdownOf(const LightMethodsPage& page);

/// A row for each method in each scene.
std::string CsvOf(const LightMethodsPage& page);

nlohmann::ordered_json ToJson(const LightMethodsPage& page);

}

#endif
