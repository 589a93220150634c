#ifndef Varimarch_Benchmarks_WorkPrecision_h
#define Varimarch_Benchmarks_WorkPrecision_h

#include "BenchMethods.h"
#include "CommandLine/PictureError.h"
#include "CommandLine/Truth.h"
#include "Scene/Volumes/VolumeLoading.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// The change of a method's error between neighbouring frames of an orbit, which the eye sees as
/// popping, crawling or flicker: the RMSE of (frame - fine frame) - (previous frame - previous fine
/// frame) [1/255]. The fine frames take the motion of the volume itself out.
struct OrbitChange
{
  int frames; ///< frames of the orbit
  double degreesPerFrame;
  double median; ///< the median change of all pairs of neighbours
  double largest;
  double largestAtDegrees; ///< azimuth from the scene's camera at which the largest change ends
};

/// The azimuth of an orbit [degrees]: it turns the view from an axis to the next.
constexpr double OrbitDegrees = 90.0;

/// The summary of the changes from frame to frame of an orbit.
/// @param changes  one for each frame but the first, at least one
OrbitChange SummaryOf(const std::vector<double>& changes);

/// Draws the same orbit with all methods, and with our mapper at eight samples per voxel as the
/// fine frames. The cameras are as before afterwards.
/// @param views   methods with their settings
/// @param frames  at least 2
std::vector<OrbitChange> ChangesInOrbit(const std::vector<MethodView*>& views, const Scene& scene,
  vtkImageData* image, int frames, const OnStep& onStep);

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
  int orbitFrames = 0;         ///< frames of an orbit, see OrbitChange; 0: none
};

/// Draws a scene with every method and setting, compares each with the truth, and measures the
/// times in rounds over all of them, so that other processes disturb all equally. Each setting is
/// drawn twice in a round, and the second frame counts, because the first one includes the
/// rebuilding that the change of setting causes.
/// @throws std::runtime_error when a mapper reports an error
WorkPrecision MeasureRuns(const std::string& name, const Scene& scene, const LoadedVolume& volume,
  const std::vector<BenchRun>& runs, const MeasuringOptions& options, const OnStep& onStep);

/// All measurements of a scene as JSON.
nlohmann::ordered_json ToJson(const WorkPrecision& scene);

}

#endif
