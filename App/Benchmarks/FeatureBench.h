#ifndef Varimarch_Benchmarks_FeatureBench_h
#define Varimarch_Benchmarks_FeatureBench_h

#include "CommandLine/Truth.h"
#include "FeatureList.h"
#include "Scene/Scene.h"

#include <vtkImageData.h>

#include <string>
#include <vector>

namespace varimarch
{

/// The time of a frame before a feature is switched on, with it, and after it is off again.
struct FeatureCost
{
  double beforeMs;
  double onMs;
  double afterMs;

  double Ratio() const { return this->onMs / this->beforeMs; }
};

/// The cost of a feature with both mappers: medians over the rounds.
struct FeatureMeasurement
{
  const Feature* feature;
  FeatureCost ours;
  FeatureCost vtk;
  std::string drawnByVtk; ///< reason why our plugin falls back to VTK's mapper; empty: it does not
  bool vtkShowsNothing;   ///< true if only VTK's image is empty; its times are then meaningless
  std::string failure;    ///< error of a mapper; empty if both have drawn the feature
};

/// Draws a scene with and without a feature, alternating between the plugin's mapper and VTK's GPU
/// mapper, with a moving camera. VTK's mapper takes one sample per voxel; ours chooses the sample
/// distance from its error tolerance.
FeatureMeasurement MeasureFeature(const Feature& feature, const Scene& scene, vtkImageData* image,
  int rounds, const OnStep& onStep);

}

#endif
