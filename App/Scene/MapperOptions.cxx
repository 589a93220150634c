#include "Scene/MapperOptions.h"

#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkVariationFieldVolumeMapper.h>

#include <algorithm>

namespace varimarch
{

namespace
{

int ModeOf(Acceleration acceleration)
{
  switch (acceleration)
  {
    case Acceleration::Off:
      return vtkVariationFieldVolumeMapper::Off;
    case Acceleration::CellField:
      return vtkVariationFieldVolumeMapper::CellField;
    case Acceleration::VariationField:
      return vtkVariationFieldVolumeMapper::VariationField;
    default:
      return vtkVariationFieldVolumeMapper::OpticalField;
  }
}

int RuleOf(std::optional<Integration> integration)
{
  if (!integration)
  {
    return vtkVariationFieldVolumeMapper::Automatic;
  }
  switch (*integration)
  {
    case Integration::PreIntegrated:
      return vtkVariationFieldVolumeMapper::PreIntegrated;
    case Integration::Simpson:
      return vtkVariationFieldVolumeMapper::Simpson;
    case Integration::PublishedSum:
      return vtkVariationFieldVolumeMapper::PublishedSum;
    case Integration::FirstHit:
      return vtkVariationFieldVolumeMapper::FirstHit;
    default:
      return vtkVariationFieldVolumeMapper::Midpoint;
  }
}

void Apply(const RenderOptions& options, vtkVariationFieldVolumeMapper* mapper)
{
  mapper->SetAutoAdjustSampleDistances(!options.HasSampleDistance());
  mapper->SetSampleDistance(options.sampleDistanceMm.value_or(mapper->GetSampleDistance()));
  mapper->SetSampleDistanceInVoxels(options.sampleDistanceVoxels.value_or(0.0));
  mapper->SetMaximumNumberOfSteps(options.mostSteps);
  mapper->SetFirstDistance(options.firstDistanceMm);
  mapper->SetAccelerationMode(ModeOf(options.acceleration));
  mapper->SetErrorTolerance(options.errorTolerance);
  mapper->SetIntegrationRule(RuleOf(options.integration));
  mapper->SetVariationTolerance(options.variationTolerance.value_or(-1.0));
  mapper->SetEarlyTerminationTransmittance(options.earlyTerminationTransmittance);
  mapper->SetLevelOfDetail(int(options.level));
  mapper->SetUseJittering(options.jitter);
  mapper->SetCompositingOrder(options.fromBehind ? vtkVariationFieldVolumeMapper::BackToFront
                                                 : vtkVariationFieldVolumeMapper::FrontToBack);
  mapper->SetStoredGradients(options.storedGradients);
}

// The sample distance of VTK's mappers, which know no voxels.
double DistanceMm(const RenderOptions& options, vtkImageData* image)
{
  const double* const spacing = image->GetSpacing();
  return options.sampleDistanceVoxels
    ? *options.sampleDistanceVoxels * std::min({ spacing[0], spacing[1], spacing[2] })
    : options.sampleDistanceMm.value_or(1.0);
}

void Apply(const RenderOptions& options, vtkImageData* image, vtkGPUVolumeRayCastMapper* mapper)
{
  mapper->SetAutoAdjustSampleDistances(!options.HasSampleDistance());
  mapper->SetSampleDistance(float(DistanceMm(options, image)));
  mapper->SetUseJittering(options.jitter);
}

void Apply(
  const RenderOptions& options, vtkImageData* image, vtkFixedPointVolumeRayCastMapper* mapper)
{
  // By default this mapper adapts its ray spacing to a frame rate, but an image must not depend on
  // the speed of the machine. Its default sample distance is 1 mm for any voxel size.
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(float(DistanceMm(options, image)));
}

}

void Apply(const RenderOptions& options, vtkImageData* image, vtkVolumeMapper* mapper)
{
  if (auto* ours = vtkVariationFieldVolumeMapper::SafeDownCast(mapper))
  {
    Apply(options, ours);
  }
  else if (auto* gpu = vtkGPUVolumeRayCastMapper::SafeDownCast(mapper))
  {
    Apply(options, image, gpu);
  }
  else
  {
    Apply(options, image, vtkFixedPointVolumeRayCastMapper::SafeDownCast(mapper));
  }
}

}
