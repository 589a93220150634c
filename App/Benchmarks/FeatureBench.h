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

/// What pictures take before a feature is switched on, with it, and when it is off again.
struct FeatureCost
{
  double beforeMs;
  double onMs;
  double afterMs;

  double Ratio() const { return this->onMs / this->beforeMs; }
};

/// A feature with both mappers: medians over the rounds.
struct FeatureMeasurement
{
  const Feature* feature;
  FeatureCost ours;
  FeatureCost vtk;
  std::string drawnByVtk; ///< why our plugin leaves it to VTK's mapper; empty: it does not
  bool vtkShowsNothing;   ///< where ours shows something: its times tell nothing
  std::string failure;    ///< what a mapper said; empty when both have drawn it
};

/// Draws a scene with and without a feature, by the plugin's mapper and by VTK's GPU mapper in
/// turn, each time as a camera moves about it. VTK's takes a sample per voxel, ours what its error
/// tolerance asks for.
FeatureMeasurement MeasureFeature(const Feature& feature, const Scene& scene, vtkImageData* image,
  int rounds, const OnStep& onStep);

}

#endif
