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
  std::size_t target; ///< index
  bool shaded;
  int side;                         ///< [pixels]
  std::vector<double> timesAsFast;  ///< speed-up on each scene where we keep the error, ascending
  std::string worstScene;           ///< scene of the least speed-up; empty without one
  std::vector<std::string> failing; ///< scenes where none of our tolerances keeps the error
  double geometricMean;             ///< of `timesAsFast`; 0 without one

  bool IsMet() const;
};

/// One per target, without targets whose rival was measured on no scene.
std::vector<SpeedSummary> SpeedSummaries(const std::vector<SpeedCase>& cases);

/// Plots the speed-up over each target's rival, scene by scene, the least first.
LogLogPlot SpeedPlot(const std::vector<SpeedCase>& cases);

}

#endif
