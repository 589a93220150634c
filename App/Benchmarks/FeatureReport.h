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

/// The measurements of `varimarch-bench features`, and how they were made.
struct FeaturePage
{
  std::string commandText;
  Machine machine; ///< state of the machine before the start
  int rounds;
  std::array<int, 2> size; ///< size of the images [pixels]
  std::string volume;      ///< name of the file
  std::vector<FeatureMeasurement> features;
};

std::string FeatureMarkdown(const FeaturePage& page);

nlohmann::ordered_json ToJson(const FeaturePage& page);

}

#endif
