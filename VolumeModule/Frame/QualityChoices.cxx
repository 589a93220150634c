#include "Frame/QualityChoices.h"

#include "Core/Recipe/MaterialRecipe.h"
#include "Frame/MapperNumbers.h"
#include "vtkVariationFieldVolumeMapper.h"

#include <stdexcept>
#include <string>

namespace varimarch
{

namespace
{

Integration IntegrationOf(int integrationRule, const RenderSettings& settings)
{
  if (settings.fromBehind)
  {
    return Integration::Midpoint;
  }
  switch (integrationRule)
  {
    case vtkVariationFieldVolumeMapper::PreIntegrated:
      return Integration::PreIntegrated;
    case vtkVariationFieldVolumeMapper::Simpson:
      return Integration::Simpson;
    case vtkVariationFieldVolumeMapper::PublishedSum:
      return Integration::PublishedSum;
    case vtkVariationFieldVolumeMapper::FirstHit:
      return Integration::FirstHit;
  }
  return Integration::Midpoint;
}

// Samples per voxel that keep a composite within half a grey level of a fine march, measured on a
// head CT with a bone transfer function. Normals turn faster than values change. A maximum only has
// to be passed closely.
double AutomaticSamplesPerVoxel(const RenderSettings& settings)
{
  if (settings.blend != Blend::Composite)
  {
    return 2.0;
  }
  return MarchesMaterial(settings) ? 8.0 : 4.0;
}

// Only an image with a tolerance has a budget; if the user sets the sample distance, it has none.
ErrorBudget BudgetOf(
  vtkVariationFieldVolumeMapper* mapper, const MapperNumbers& numbers, const Frame& frame)
{
  ErrorBudget budget;
  budget.tolerance = mapper->GetAutoAdjustSampleDistances() ? numbers.errorTolerance : 0.0;
  budget.windowScale = frame.image.windowScaleBias.x;
  budget.isExtreme = IsExtreme(frame.settings.blend);
  // Boxes are marched from face to face, but the light in them is sampled, or that of lattices.
  budget.isSampled =
    IsSampled(frame.settings) || IsInWayOfLights(frame.settings) || IsInWayOfSky(frame.settings);
  budget.isOccluded = frame.settings.occlusion;
  return budget;
}

// The sample distance that the user sets.
double ChosenSampleDistanceMm(const MapperNumbers& numbers, const Frame& frame)
{
  return numbers.sampleDistanceInVoxels > 0.0
    ? numbers.sampleDistanceInVoxels * frame.geometry.SmallestSpacingMm()
    : numbers.sampleDistanceMm;
}

}

void CheckIntegrationRule(vtkVariationFieldVolumeMapper* mapper, const RenderSettings& settings)
{
  const bool isSum = mapper->GetIntegrationRule() == vtkVariationFieldVolumeMapper::PublishedSum;
  const bool isPublished =
    isSum || mapper->GetIntegrationRule() == vtkVariationFieldVolumeMapper::FirstHit;
  const bool dependsOnMore =
    MarchesMaterial(settings) || !IsSampled(settings) || settings.fromBehind;
  if (isPublished && settings.blend == Blend::Composite && dependsOnMore)
  {
    throw std::runtime_error(std::string("The integration rule ") +
      (isSum ? "PublishedSum" : "FirstHit") +
      " is defined only for interpolated values of one component, front to back, without light, "
      "gradient opacity and labels: switch these off, as by ShadeOff, or choose another rule");
  }
}

void ChooseQuality(
  vtkVariationFieldVolumeMapper* mapper, const MapperNumbers& numbers, Frame& frame)
{
  QualityRequest& quality = frame.quality;
  quality.budget = BudgetOf(mapper, numbers, frame);
  frame.settings.triesRays = quality.budget.StepTolerance() > 0.0;
  quality.choosesIntegration =
    mapper->GetIntegrationRule() == vtkVariationFieldVolumeMapper::Automatic &&
    frame.settings.blend == Blend::Composite && IsSampled(frame.settings) &&
    !frame.settings.fromBehind;
  quality.variationTolerance = numbers.variationTolerance;
  quality.earlyTerminationTransmittance =
    quality.budget.EarlyTermination(numbers.earlyTerminationTransmittance);
  quality.sampleDistanceMm = mapper->GetAutoAdjustSampleDistances()
    ? frame.geometry.SmallestSpacingMm() / AutomaticSamplesPerVoxel(frame.settings)
    : ChosenSampleDistanceMm(numbers, frame);
  frame.settings.integration = IntegrationOf(mapper->GetIntegrationRule(), frame.settings);
  if (quality.choosesIntegration && MarchesMaterial(frame.settings) &&
    quality.budget.StepTolerance() == 0.0)
  {
    // No trial chooses these short steps, at which this rule has the smaller error.
    frame.settings.integration = Integration::PreIntegrated;
  }
}

// A number of steps has a meaning only if these are of known length.
void ChooseSpan(vtkVariationFieldVolumeMapper* mapper, const MapperNumbers& numbers, Frame& frame)
{
  frame.span.firstDistanceMm = numbers.firstDistanceMm;
  frame.span.mostSteps =
    mapper->GetAutoAdjustSampleDistances() ? 0 : mapper->GetMaximumNumberOfSteps();
  frame.settings.limitsSpan = frame.span.firstDistanceMm > 0.0 || frame.span.mostSteps > 0;
}

}
