#ifndef Varimarch_Benchmarks_WorkPrecision_h
#define Varimarch_Benchmarks_WorkPrecision_h

#include "BenchMethods.h"
#include "CommandLine/PictureError.h"
#include "CommandLine/Truth.h"
#include "OrbitChange.h"
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
  double sampleDistanceMm; ///< sample distance that the mapper used
  double estimatedError;   ///< the mapper's estimate, [0, 1]; 0 if the sample distance was given
  PictureError error;
  std::optional<double> fetchesPerPixel; ///< see FrameCost.h
  std::optional<double> graphicsBytes;   ///< see FrameCost.h
  std::vector<double> roundsMs;
  double medianMs;
};

struct WorkCurve
{
  BenchMethod method;
  std::vector<WorkPoint> points;         ///< points, coarsest first, at least one
  std::string skipped;                   ///< settings that would take too long; empty: none
  bool eightBits;                        ///< true if its images are rounded to 8 bits
  std::size_t shown;                     ///< index of the point that `picture` shows
  vtkSmartPointer<vtkImageData> picture; ///< float image, near one sample per voxel
  std::optional<OrbitChange> orbit;      ///< measured at the point that `picture` shows
};

/// Error against run time of several methods on one scene.
struct WorkPrecision
{
  std::string name; ///< name of the scene, usable as a file name
  Scene scene;
  LoadedVolume volume;
  Truth truth;
  double eightBitRmse; ///< RMSE of the truth rounded to 8 bits [1/255]
  std::vector<WorkCurve> curves;
  std::string openglRenderer;
};

struct MeasuringOptions
{
  int rounds = 3;
  double longestSeconds = 3.0; ///< time of a frame after which finer settings are skipped
  int orbitFrames = 0;         ///< frames of an orbit, see OrbitChange.h; 0: none
};

/// Draws a scene with every method and setting, compares each with the truth, and measures the
/// times in rounds over all of them, so that other processes disturb all equally. Each setting is
/// drawn twice in a round, and the second frame counts, because the first one includes the
/// rebuilding that the change of setting causes.
/// @throws std::runtime_error when a mapper reports an error
WorkPrecision MeasureRuns(const std::string& name, const Scene& scene, const LoadedVolume& volume,
  const std::vector<BenchRun>& runs, const MeasuringOptions& options, const OnStep& onStep);

/// The curve of a method; null if it was not measured on the scene.
const WorkCurve* CurveOf(const WorkPrecision& scene, const std::string& method);

/// The sample distance of a point in smallest voxel spacings.
double VoxelsOf(const WorkPrecision& scene, const WorkPoint& point);

/// The time of a method at an error, interpolated between its settings along straight lines of the
/// log-log plot. If even its coarsest setting has a smaller error, that setting's time; empty if no
/// setting has so small an error.
/// @param measure  the measure of error, such as &ImageError::rootMeanSquare
/// @param error    error, > 0 [1/255]
std::optional<double> MillisecondsAtError(
  const WorkCurve& curve, double ImageError::*measure, double error);

}

#endif
