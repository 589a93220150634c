#ifndef Varimarch_CommandLine_BenchMethods_h
#define Varimarch_CommandLine_BenchMethods_h

#include "Scene/LogLogPlot.h"
#include "Scene/Scene.h"

#include <vtkImageData.h>

#include <string>
#include <vector>

namespace varimarch
{

/// A way to draw that a benchmark sweeps over sample distances: a row of one table, so that
/// another way is another row.
struct BenchMethod
{
  std::string name;  ///< on the command line and in tables
  std::string title; ///< for people
  MapperKind kind;
  RenderOptions options; ///< but for the sample distance and the tolerance of the scalar field
  double variation255;   ///< that tolerance, in 1/255 of the range of the data
  bool unshadedOnly;     ///< what it is about is not used in shaded volumes
  CurveStyle style;
};

const std::vector<BenchMethod>& BenchMethods();

std::vector<std::string> BenchMethodNames();

/// One of a method's sample distances.
struct BenchSetting
{
  double voxels; ///< sample distance in smallest distances of voxels
  RenderOptions options;
};

/// A method with what it is to be measured at, the coarsest setting first.
struct BenchRun
{
  BenchMethod method;
  std::vector<BenchSetting> settings;
};

/// The work-precision runs of a scene: the chosen methods that are about something in it, over
/// sample distances from 4 voxels to an eighth of one.
/// @param chosen  names; empty: all
std::vector<BenchRun> WorkPrecisionRuns(
  const Scene& scene, vtkImageData* image, const std::vector<std::string>& chosen);

/// The smallest distance of voxels [mm].
double VoxelMm(vtkImageData* image);

/// A part of the range of a volume's values, in 1/255 of it, in units of the data.
double Variation(vtkImageData* image, double variation255);

}

#endif
