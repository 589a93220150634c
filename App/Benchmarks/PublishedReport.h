#ifndef Varimarch_Benchmarks_PublishedReport_h
#define Varimarch_Benchmarks_PublishedReport_h

#include "Machine.h"
#include "PublishedFigures.h"
#include "PublishedScenes.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace varimarch
{

struct PublishedPage
{
  std::string commandText;
  Machine machine;
  PublishedMeasurements measured;
  std::vector<PublishedFigure> figures;
};

/// The measurements beside the published figures, as Markdown; at least one data set.
std::string PublishedMarkdown(const PublishedPage& page);

nlohmann::ordered_json ToJson(const PublishedPage& page);

}

#endif
