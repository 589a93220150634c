#ifndef Varimarch_Benchmarks_FeatureReport_h
#define Varimarch_Benchmarks_FeatureReport_h

#include "FeatureBench.h"
#include "Machine.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <string>
#include <vector>

namespace varimarch
{

/// What `varimarch-bench features` has measured, and how.
struct FeaturePage
{
  std::string commandText;
  Machine machine; ///< before the start
  int rounds;
  std::array<int, 2> size; ///< of the pictures [pixels]
  std::string volume;      ///< that they show
  std::vector<FeatureMeasurement> features;
};

std::string FeatureMarkdown(const FeaturePage& page);

nlohmann::ordered_json ToJson(const FeaturePage& page);

}

#endif
