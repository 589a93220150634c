#ifndef Varimarch_Promise_PromiseReport_h
#define Varimarch_Promise_PromiseReport_h

#include "PromiseRun.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace varimarch
{

/// The numbers of pictures of a kind, or of all kinds, by their verdict.
struct PromiseCounts
{
  int pictures = 0;
  int kept = 0; ///< within the tolerance
  int silentMisses = 0;
  int falseAlarms = 0;
  int unsettled = 0;
  int messages = 0;         ///< pictures with an error or a warning
  double worstFactor = 0.0; ///< largest one where the mapper says "kept" [tolerances]
  double drawSeconds = 0.0;
  double judgeSeconds = 0.0;

  void Add(const PromisePicture& picture);
};

/// A table with a row for each kind, and the pictures that break the promise with the command that
/// draws each alone.
std::string PromiseMarkdown(const std::vector<PromisePicture>& pictures);

/// The command that draws the scene of a picture alone.
std::string CommandFor(const PromisePicture& picture);

nlohmann::ordered_json PromiseJson(const std::vector<PromisePicture>& pictures);

}

#endif
