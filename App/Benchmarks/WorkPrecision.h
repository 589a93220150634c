#ifndef Varimarch_Benchmarks_WorkPrecision_h
#define Varimarch_Benchmarks_WorkPrecision_h

#include "BenchMethods.h"
#include "CommandLine/PictureError.h"
#include "CommandLine/Truth.h"
#include "Scene/VolumeLoading.h"

#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// What one setting of a method costs and yields.
struct WorkPoint
{
  BenchSetting setting;
  double sampleDistanceMm; ///< between the samples of its picture
  double estimatedError;   ///< the mapper's own, of 1; 0 for a sample distance that it was given
  PictureError error;
  std::optional<double> fetchesPerPixel; ///< readings of the volume; VTK's mappers do not tell
  std::vector<double> roundsMs;
  double medianMs;
};

struct WorkCurve
{
  BenchMethod method;
  std::vector<WorkPoint> points;         ///< the coarsest first, at least one
  std::string skipped;                   ///< which settings took too long; empty: none
  bool eightBits;                        ///< its pictures hold nothing finer
  std::size_t shown;                     ///< the point of the picture
  vtkSmartPointer<vtkImageData> picture; ///< float picture, near one sample per voxel
};

/// Error against run time of several methods on one scene.
struct WorkPrecision
{
  std::string name; ///< of the scene, fit for a file name
  Scene scene;
  LoadedVolume volume;
  Truth truth;
  double eightBitRmse; ///< of the truth itself, rounded to 8 bits [1/255]
  std::vector<WorkCurve> curves;
  std::string openglRenderer;
};

struct MeasuringOptions
{
  int rounds = 3;
  double longestSeconds = 3.0; ///< a method's finer settings are left out when one took longer
};

/// Draws a scene with every method and setting, compares each with the truth, and measures the
/// times in rounds that go through all of them in turn, so that what else the machine does disturbs
/// all alike. Each setting is drawn twice in a round, and the second picture counts: the first
/// pays for what the change of setting rebuilds.
/// @throws std::runtime_error when a mapper reports an error
WorkPrecision MeasureRuns(const std::string& name, const Scene& scene, const LoadedVolume& volume,
  const std::vector<BenchRun>& runs, const MeasuringOptions& options, const OnStep& onStep);

/// The curve of a method that was run on a scene; null when it was not.
const WorkCurve* CurveOf(const WorkPrecision& scene, const std::string& method);

/// The distance between a point's samples, in smallest distances of voxels.
double VoxelsOf(const WorkPrecision& scene, const WorkPoint& point);

/// The time of a method at an error, between its settings by straight lines in the log-log plot.
/// Where even its coarsest setting errs less, that one's time; empty where it never errs so little.
/// @param measure  which of the errors, such as &ImageError::rootMeanSquare
/// @param error    > 0, in 1/255
std::optional<double> MillisecondsAtError(
  const WorkCurve& curve, double ImageError::*measure, double error);

}

#endif
