#ifndef Varimarch_Benchmarks_PublishedReport_h
#define Varimarch_Benchmarks_PublishedReport_h

#include "Machine.h"
#include "PublishedScenes.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace varimarch
{

struct PublishedPage
{
  std::string commandText;
  Machine machine;
  PublishedMeasurements measured;
};

/// A page with the papers' figures beside ours, and the differences between the setups.
std::string PublishedMarkdown(const PublishedPage& page);

nlohmann::ordered_json ToJson(const PublishedPage& page);

}

#endif
