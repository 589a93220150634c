#ifndef Varimarch_Benchmarks_SpeedSummary_h
#define Varimarch_Benchmarks_SpeedSummary_h

#include "LogLogPlot.h"
#include "SpeedBench.h"

#include <string>
#include <vector>

namespace varimarch
{

/// The result of a target over all scenes of one size, shaded or not.
struct SpeedSummary
{
  std::size_t target; ///< index of the target
  bool shaded;
  int side;                         ///< side of the image [pixels]
  std::vector<double> timesAsFast;  ///< speed-up on each scene where we keep the error, ascending
  std::string worstScene;           ///< scene of the smallest speed-up; empty without one
  std::vector<std::string> failing; ///< scenes where none of our tolerances keeps the error
  double geometricMean;             ///< geometric mean of `timesAsFast`; 0 without any

  bool IsMet() const;
};

/// The summaries of all targets whose rival was measured on some scene.
std::vector<SpeedSummary> SpeedSummaries(const std::vector<SpeedCase>& cases);

/// Plots the speed-up over each target's rival, scene by scene, smallest first.
LogLogPlot SpeedPlot(const std::vector<SpeedCase>& cases);

}

#endif
