#ifndef Varimarch_Benchmarks_SpeedBench_h
#define Varimarch_Benchmarks_SpeedBench_h

#include "CommandLine/Truth.h"
#include "Core/Quality/ImageError.h"
#include "FrameCost.h"
#include "LogLogPlot.h"
#include "SpeedScenes.h"

#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// A method's measurements on one scene.
struct SpeedPoint
{
  std::string method; ///< "ours", "off", each also "-shader", "published", "vtk-gpu" or "vtk-cpu"
  MapperKind kind;
  RenderOptions options;
  double firstSeconds;                   ///< time of the first frame
  ImageError error;                      ///< error against the truth
  std::optional<double> fetchesPerPixel; ///< see FrameCost.h
  std::optional<double> graphicsBytes;   ///< see FrameCost.h
  std::vector<FrameCost>
    rounds;         ///< one per comparison and round; without comparisons one per round
  FrameCost median; ///< median of the rounds
};

/// A goal: to be faster than another method by a factor, at an error of at most a fraction of its
/// error.
struct SpeedTarget
{
  std::string title;
  std::string rival;   ///< method to compare with
  std::string ours;    ///< our method, marched on the same device as the rival
  double partOfError;  ///< limit of our RMSE, as a fraction of the rival's
  double timesWanted;  ///< speed-up over the rival, geometric mean of all scenes
  double timesAtLeast; ///< speed-up on every scene; 0: no goal
  CurveStyle style;    ///< style in a plot
};

const std::vector<SpeedTarget>& SpeedTargets();

/// All measurements on one scene at one size.
struct SpeedCase
{
  std::string scene;
  bool shaded;
  int side;                       ///< side of the square image [pixels]
  std::vector<SpeedPoint> points; ///< points: default settings first, then ours at other tolerances
  /// Index of our point with the largest tolerance that keeps the error of each target; empty if
  /// none does, or if the rival does not apply to the scene.
  std::vector<std::optional<std::size_t>> keeping;
  /// Speed-up in each round over each target's rival. Both were drawn one right after the other.
  std::vector<std::vector<double>> timesAsFast;
  std::string openglRenderer;
};

/// The point of a target's rival; null if it was not measured.
const SpeedPoint* Rival(const SpeedCase& measured, const SpeedTarget& target);

/// Our speed-up over a target's rival at the point that keeps the error: the median of all rounds.
std::optional<double> TimesAsFast(const SpeedCase& measured, std::size_t target);

struct SpeedOptions
{
  std::vector<int> sides = { 256, 512, 1024 };
  std::vector<bool> shaded = { false, true };
  int rounds = 3;
  double longestSeconds = 20.0; ///< time above which frames are drawn in one round only
};

/// Draws a scene at each size, shaded and not, in rounds: each method at its default setting, and
/// ours also at the error tolerances that the targets need. The two methods of a target are drawn
/// one right after the other, in alternating order, each in a new window with a new mapper.
/// @throws std::runtime_error when a mapper reports an error
std::vector<SpeedCase> MeasureSpeed(
  const LoadedScene& loaded, const SpeedOptions& options, const OnStep& onStep);

}

#endif
