#ifndef Varimarch_Benchmarks_SpeedSummary_h
#define Varimarch_Benchmarks_SpeedSummary_h

#include "LogLogPlot.h"
#include "SpeedBench.h"

#include <string>
#include <vector>

namespace varimarch
{

/// A target over all scenes of one size, shaded or not.
struct SpeedSummary
{
  std::size_t target; ///< index
  bool shaded;
  int side;                         ///< [pixels]
  std::vector<double> timesAsFast;  ///< of each scene where we keep the error, the slowest first
  std::string worstScene;           ///< the slowest of them; empty without one
  std::vector<std::string> failing; ///< scenes where no tolerance of ours keeps the error
  double geometricMean;             ///< of `timesAsFast`; 0 without one

  bool IsMet() const;
};

/// Target by target; without those whose rival was measured on no scene.
std::vector<SpeedSummary> SpeedSummaries(const std::vector<SpeedCase>& cases);

/// How many times as fast as each target's rival, scene by scene, the slowest first.
LogLogPlot SpeedPlot(const std::vector<SpeedCase>& cases);

}

#endif
