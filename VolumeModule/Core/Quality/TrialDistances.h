#ifndef Varimarch_Core_Quality_TrialDistances_h
#define Varimarch_Core_Quality_TrialDistances_h

#include "Core/Quality/StepSearch.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace varimarch
{

/// A sample distance, first, and those that a search of half octaves may draw next. Each image is
/// compared with one at a quarter of its distance, and shorter distances take most of the time.
inline std::vector<double> DistancesDrawnWith(double distance, const StepRange& range)
{
  constexpr int HalvesLonger = 4;
  constexpr int HalvesShorter = 8;
  std::vector<double> distances = { distance };
  for (int halves = -HalvesShorter; halves <= HalvesLonger; ++halves)
  {
    distances.push_back(
      std::clamp(distance * std::exp2(0.5 * halves), 0.5 * range.finest, range.coarsest));
  }
  return distances;
}

}

#endif
