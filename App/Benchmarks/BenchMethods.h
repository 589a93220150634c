#ifndef Varimarch_Benchmarks_BenchMethods_h
#define Varimarch_Benchmarks_BenchMethods_h

#include "LogLogPlot.h"
#include "Scene/Scene.h"

#include <vtkImageData.h>

#include <string>
#include <vector>

namespace varimarch
{

/// A way to draw that a benchmark sweeps over settings.
struct BenchMethod
{
  std::string name;  ///< on the command line and in tables
  std::string title; ///< for people
  MapperKind kind;
  CurveStyle style;
};

std::vector<std::string> BenchMethodNames();

/// One of the settings that a method is swept over.
struct BenchSetting
{
  std::string label; ///< what tells it from the method's other ones, such as "0.5 voxels"
  RenderOptions options;
};

/// A method with what it is to be measured at, the coarsest setting first.
struct BenchRun
{
  BenchMethod method;
  std::vector<BenchSetting> settings;
};

/// The work-precision runs of a scene: the chosen methods that are about something in it, our
/// defaults over error tolerances and all others over sample distances.
/// @param chosen  names; empty: all
std::vector<BenchRun> WorkPrecisionRuns(
  const Scene& scene, vtkImageData* image, const std::vector<std::string>& chosen);

/// Those options with a sample distance in smallest distances of voxels.
BenchSetting AtDistance(vtkImageData* image, double voxels, const RenderOptions& options);

/// The smallest distance of voxels [mm].
double VoxelMm(vtkImageData* image);

/// A part of the range of a volume's values, in 1/255 of it, in units of the data.
double Variation(vtkImageData* image, double variation255);

}

#endif
