#include "Frame/MapperNumbers.h"

#include "Frame/NumberCheck.h"
#include "vtkVariationFieldVolumeMapper.h"

#include <limits>

namespace varimarch
{

namespace
{

// The numbers of fields, rays and steps.
void TakeSampling(vtkVariationFieldVolumeMapper* mapper, NumberCheck& check, MapperNumbers& numbers)
{
  constexpr double Shortest = 1e-30;
  constexpr double LeastPixels = 0.1;
  constexpr double MostPixels = 100.0;
  numbers.errorTolerance =
    check.Usable({ "SetErrorTolerance", 0.0, 1.0, 1.0 / 64.0 }, mapper->GetErrorTolerance());
  numbers.variationTolerance =
    check.Usable({ "SetVariationTolerance", -LargestSetting, LargestSetting, -1.0 },
      mapper->GetVariationTolerance());
  numbers.sampleDistanceMm = check.Usable(
    { "SetSampleDistance", Shortest, LargestSetting, 1.0 }, mapper->GetSampleDistance());
  numbers.sampleDistanceInVoxels =
    check.Usable({ "SetSampleDistanceInVoxels", 0.0 }, mapper->GetSampleDistanceInVoxels());
  numbers.firstDistanceMm = check.Usable({ "SetFirstDistance", 0.0 }, mapper->GetFirstDistance());
  numbers.earlyTerminationTransmittance =
    check.Usable({ "SetEarlyTerminationTransmittance", 0.0, 1.0, 1.0 / 1024.0 },
      mapper->GetEarlyTerminationTransmittance());
  numbers.imageSampleDistance = check.Usable(
    { "SetImageSampleDistance", LeastPixels, MostPixels, 1.0 }, mapper->GetImageSampleDistance());
  numbers.interactiveSampleDistances = {
    check.Usable({ "SetMinimumImageSampleDistance", LeastPixels, MostPixels, 1.0 },
      mapper->GetMinimumImageSampleDistance()),
    check.Usable({ "SetMaximumImageSampleDistance", LeastPixels, MostPixels, 10.0 },
      mapper->GetMaximumImageSampleDistance())
  };
  numbers.longestPartSeconds =
    check.Usable({ "SetLongestPartSeconds", 0.0, std::numeric_limits<double>::max() },
      mapper->GetLongestPartSeconds());
}

void TakeImage(vtkVariationFieldVolumeMapper* mapper, NumberCheck& check, MapperNumbers& numbers)
{
  constexpr double Infinite = std::numeric_limits<double>::infinity();
  numbers.window = check.Usable(
    { "SetFinalColorWindow", -LargestSetting, LargestSetting, 1.0 }, mapper->GetFinalColorWindow());
  numbers.level = check.Usable(
    { "SetFinalColorLevel", -LargestSetting, LargestSetting, 0.5 }, mapper->GetFinalColorLevel());
  numbers.nanColor = check.Usable({ "SetNanColor", 0.0, 1.0, 0.0 }, mapper->GetNanColor());
  numbers.nanOpacity = check.Usable({ "SetNanOpacity", 0.0, 1.0 }, mapper->GetNanOpacity());
  const double* const averaged = mapper->GetAverageIPScalarRange();
  numbers.averagedRange = {
    check.Usable({ "SetAverageIPScalarRange", -Infinite, Infinite, -Infinite }, averaged[0]),
    check.Usable({ "SetAverageIPScalarRange", -Infinite, Infinite, Infinite }, averaged[1])
  };
  numbers.maskBlendFactor =
    check.Usable({ "SetMaskBlendFactor", 0.0, 1.0, 1.0 }, mapper->GetMaskBlendFactor());
}

void TakeLight(vtkVariationFieldVolumeMapper* mapper, NumberCheck& check, MapperNumbers& numbers)
{
  numbers.dampingGradient =
    check.Usable({ "SetDampingGradient", 0.0 }, mapper->GetDampingGradient());
  numbers.shadowStrength =
    check.Usable({ "SetShadowStrength", 0.0, 1.0, 1.0 }, mapper->GetShadowStrength());
  numbers.scatteringBlending = check.Usable(
    { "SetVolumetricScatteringBlending", 0.0, 2.0 }, mapper->GetVolumetricScatteringBlending());
  numbers.illuminationReach =
    check.Usable({ "SetGlobalIlluminationReach", 0.0, 1.0 }, mapper->GetGlobalIlluminationReach());
  numbers.scatteringAnisotropy =
    check.Usable({ "SetScatteringAnisotropy", -1.0, 1.0 }, mapper->GetScatteringAnisotropy());
  numbers.occlusion =
    check.Usable({ "SetAmbientOcclusion", 0.0, 1.0 }, mapper->GetAmbientOcclusion());
  numbers.occlusionReachMm =
    check.Usable({ "SetAmbientOcclusionReach", 0.0 }, mapper->GetAmbientOcclusionReach());
}

}

MapperNumbers MapperNumbersOf(vtkVariationFieldVolumeMapper* mapper, NumberCheck& check)
{
  MapperNumbers numbers = {};
  TakeSampling(mapper, check, numbers);
  TakeImage(mapper, check, numbers);
  TakeLight(mapper, check, numbers);
  return numbers;
}

}
