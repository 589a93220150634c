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

/// A way to draw, measured on one scene.
struct SpeedPoint
{
  std::string method; ///< "ours", "off", each also "-shader", "published", "vtk-gpu" or "vtk-cpu"
  MapperKind kind;
  RenderOptions options;
  double firstSeconds;                   ///< that its first picture took
  ImageError error;                      ///< against the truth
  std::optional<double> fetchesPerPixel; ///< see FrameCost.h, as the next
  std::optional<double> graphicsBytes;
  std::vector<FrameCost> rounds; ///< of each round those of each comparison, or one without any
  FrameCost median;              ///< of these
};

/// How fast we want to be where we err less than another method by a factor.
struct SpeedTarget
{
  std::string title;
  std::string rival;   ///< a method
  std::string ours;    ///< the one that is to be faster: rays by whom the rival's are marched
  double partOfError;  ///< our RMSE is to be below this part of the rival's
  double timesWanted;  ///< as fast as the rival, geometric mean of all scenes
  double timesAtLeast; ///< on every scene; 0: no matter
  CurveStyle style;    ///< in a plot
};

const std::vector<SpeedTarget>& SpeedTargets();

/// One scene at one size with all that was measured.
struct SpeedCase
{
  std::string scene;
  bool shaded;
  int side;                       ///< of the square picture [pixels]
  std::vector<SpeedPoint> points; ///< default settings first, then ours at further tolerances
  /// For each target the point of ours that keeps its error at the largest tolerance; empty where
  /// none does, or the rival is not about anything in the scene.
  std::vector<std::optional<std::size_t>> keeping;
  /// For each target, of each round in which both were drawn one right after the other.
  std::vector<std::vector<double>> timesAsFast;
  std::string openglRenderer;
};

/// @return null where the rival was not measured
const SpeedPoint* Rival(const SpeedCase& measured, const SpeedTarget& target);

/// How many times as fast as the rival of a target we are where we keep its error: the median of
/// all rounds.
std::optional<double> TimesAsFast(const SpeedCase& measured, std::size_t target);

struct SpeedOptions
{
  std::vector<int> sides = { 256, 512, 1024 };
  std::vector<bool> shaded = { false, true };
  int rounds = 3;
  double longestSeconds = 20.0; ///< what takes longer is drawn in one round only
};

/// Draws a scene at each size, shaded and not, with each method at its default setting and with
/// ours at the error tolerances that the targets need, in rounds. In each, what a target compares
/// is drawn one right after the other, in turn first and second. All make a new window and mapper.
/// @throws std::runtime_error when a mapper reports an error
std::vector<SpeedCase> MeasureSpeed(
  const LoadedScene& loaded, const SpeedOptions& options, const OnStep& onStep);

}

#endif
