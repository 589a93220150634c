#include "FeatureBench.h"

#include "CommandLine/Results.h"
#include "FeatureView.h"
#include "Scene/Median.h"

#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkSmartPointer.h>
#include <vtkVariationFieldGPUVolumeRayCastMapper.h>

#include <stdexcept>

namespace varimarch
{

namespace
{

FeatureCost CostOf(const Feature& feature, FeatureView& view)
{
  FeatureCost cost = {};
  feature.prepare(view.Stage());
  cost.beforeMs = view.MedianMs();
  feature.switchOn(view.Stage());
  cost.onMs = view.MedianMs();
  feature.switchOff(view.Stage());
  cost.afterMs = view.MedianMs();
  return cost;
}

FeatureCost MedianOf(const std::vector<FeatureCost>& costs)
{
  FeatureCost median = {};
  for (double FeatureCost::*time :
    { &FeatureCost::beforeMs, &FeatureCost::onMs, &FeatureCost::afterMs })
  {
    std::vector<double> times;
    for (const FeatureCost& cost : costs)
    {
      times.push_back(cost.*time);
    }
    median.*time = Median(times);
  }
  return median;
}

void SwitchOn(const Feature& feature, FeatureView& view)
{
  feature.prepare(view.Stage());
  feature.switchOn(view.Stage());
  view.MedianMs();
}

// Checks how each mapper handles the feature.
void FindWhoDraws(const Scene& scene, vtkImageData* image, FeatureMeasurement& measurement)
{
  const auto ours = vtkSmartPointer<vtkVariationFieldGPUVolumeRayCastMapper>::New();
  FeatureView ourView(scene, image, ours);
  SwitchOn(*measurement.feature, ourView);
  measurement.drawnByVtk = ours->GetReasonForVtkMapper();

  FeatureView vtkView(scene, image, vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New());
  SwitchOn(*measurement.feature, vtkView);
  measurement.vtkShowsNothing = vtkView.ShowsNothing() && !ourView.ShowsNothing();
}

}

FeatureMeasurement MeasureFeature(
  const Feature& feature, const Scene& scene, vtkImageData* image, int rounds, const OnStep& onStep)
{
  FeatureMeasurement measurement = { &feature, {}, {}, "", false, "" };
  try
  {
    FindWhoDraws(scene, image, measurement);
    std::vector<FeatureCost> ours;
    std::vector<FeatureCost> vtk;
    for (int round = 1; round <= rounds; ++round)
    {
      onStep(feature.name + ", round " + std::to_string(round) + " of " + std::to_string(rounds));
      FeatureView ourView(
        scene, image, vtkSmartPointer<vtkVariationFieldGPUVolumeRayCastMapper>::New());
      ours.push_back(CostOf(feature, ourView));
      FeatureView vtkView(scene, image, vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New());
      vtk.push_back(CostOf(feature, vtkView));
    }
    measurement.ours = MedianOf(ours);
    measurement.vtk = MedianOf(vtk);
  }
  catch (const std::runtime_error& problem)
  {
    measurement.failure = problem.what();
  }
  return measurement;
}

}
