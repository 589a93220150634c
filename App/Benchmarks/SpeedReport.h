#ifndef Varimarch_Benchmarks_SpeedReport_h
#define Varimarch_Benchmarks_SpeedReport_h

#include "Machine.h"
#include "SpeedBench.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace varimarch
{

/// The measurements of `varimarch-bench speed`, and how they were made.
struct SpeedPage
{
  std::string commandText;
  Machine machine; ///< state of the machine before the start
  SpeedOptions options;
  std::vector<std::string> missing; ///< files of scenes that were skipped
  std::vector<SpeedCase> cases;     ///< measurements, at least one
};

std::string SpeedMarkdown(const SpeedPage& page);

nlohmann::ordered_json ToJson(const SpeedPage& page);

nlohmann::ordered_json ToJson(const FrameCost& cost);

/// A number of bytes in MiB, or a dash.
std::string Mebibytes(const std::optional<double>& bytes);

}

#endif
