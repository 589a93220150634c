#ifndef Varimarch_Benchmarks_ScalingReport_h
#define Varimarch_Benchmarks_ScalingReport_h

#include "LogLogPlot.h"
#include "Machine.h"
#include "ScalingBench.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <string>
#include <vector>

namespace varimarch
{

/// The measurements of `varimarch-bench scaling`, and how they were made.
struct ScalingPage
{
  std::string commandText;
  Machine machine; ///< state of the machine before the start
  int rounds;
  std::array<int, 2> size; ///< size of the images [pixels]
  std::vector<ScalingCurve> curves;
};

std::string ScalingMarkdown(const ScalingPage& page);

nlohmann::ordered_json ToJson(const ScalingPage& page);

/// Plots times over the side of the volume.
LogLogPlot ScalingPlot(const std::vector<ScalingCurve>& curves);

}

#endif
