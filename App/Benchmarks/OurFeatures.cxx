#include "OurFeatures.h"

#include <vtkVariationFieldGPUVolumeRayCastMapper.h>
#include <vtkVariationFieldVolumeMapper.h>

namespace varimarch
{

namespace
{

void WithOurs(
  const FeatureStage& stage, const std::function<void(vtkVariationFieldVolumeMapper*)>& set)
{
  auto* adapter = vtkVariationFieldGPUVolumeRayCastMapper::SafeDownCast(stage.mapper);
  if (adapter)
  {
    set(adapter->GetVariationFieldMapper());
  }
}

}

void CubicOn(const FeatureStage& stage)
{
  WithOurs(stage, [](vtkVariationFieldVolumeMapper* mapper) { mapper->CubicInterpolationOn(); });
}

void CubicOff(const FeatureStage& stage)
{
  WithOurs(stage, [](vtkVariationFieldVolumeMapper* mapper) { mapper->CubicInterpolationOff(); });
}

// Damps by a fortieth of the steepest slope that two neighbouring voxels can have.
void DampingOn(const FeatureStage& stage)
{
  const double* range = stage.image->GetScalarRange();
  const double gradient = (range[1] - range[0]) / stage.image->GetSpacing()[0] / 40.0;
  WithOurs(stage,
    [gradient](vtkVariationFieldVolumeMapper* mapper) { mapper->SetDampingGradient(gradient); });
}

void DampingOff(const FeatureStage& stage)
{
  WithOurs(stage, [](vtkVariationFieldVolumeMapper* mapper) { mapper->SetDampingGradient(0.0); });
}

}
