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

/// The time and error of one setting of a method.
struct WorkPoint
{
  BenchSetting setting;
  double sampleDistanceMm; ///< used by the mapper
  double estimatedError;   ///< the mapper's estimate, of 1; 0 if the sample distance was given
  PictureError error;
  std::optional<double> fetchesPerPixel; ///< samples of the volume; empty for VTK's mappers
  std::vector<double> roundsMs;
  double medianMs;
};

struct WorkCurve
{
  BenchMethod method;
  std::vector<WorkPoint> points;         ///< the coarsest first, at least one
  std::string skipped;                   ///< settings that took too long; empty: none
  bool eightBits;                        ///< true if its images are rounded to 8 bits
  std::size_t shown;                     ///< index of the point that `picture` shows
  vtkSmartPointer<vtkImageData> picture; ///< float image, near one sample per voxel
};

/// Error against run time of several methods on one scene.
struct WorkPrecision
{
  std::string name; ///< of the scene, fit for a file name
  Scene scene;
  LoadedVolume volume;
  Truth truth;
  double eightBitRmse; ///< of the truth rounded to 8 bits [1/255]
  std::vector<WorkCurve> curves;
  std::string openglRenderer;
};

struct MeasuringOptions
{
  int rounds = 3;
  double longestSeconds = 3.0; ///< finer settings are left out after one that took longer
};

/// Draws a scene with every method and setting, compares each with the truth, and measures the
/// times in rounds over all of them, so that other processes disturb all alike. Each setting is
/// drawn twice in a round, and the second frame counts: the first one includes the rebuilding that
/// the change of setting causes.
/// @throws std::runtime_error when a mapper reports an error
WorkPrecision MeasureRuns(const std::string& name, const Scene& scene, const LoadedVolume& volume,
  const std::vector<BenchRun>& runs, const MeasuringOptions& options, const OnStep& onStep);

/// The curve of a method; null if it was not measured on the scene.
const WorkCurve* CurveOf(const WorkPrecision& scene, const std::string& method);

/// The sample distance of a point in smallest voxel spacings.
double VoxelsOf(const WorkPrecision& scene, const WorkPoint& point);

/// The time of a method at an error, interpolated between its settings along straight lines of the
/// log-log plot. If even its coarsest setting errs less, the time of that one; empty if none of its
/// settings errs so little.
/// @param measure  the measure of error, such as &ImageError::rootMeanSquare
/// @param error    > 0, in 1/255
std::optional<double> MillisecondsAtError(
  const WorkCurve& curve, double ImageError::*measure, double error);

}

#endif
