#include "Frame/PictureChoices.h"

#include "Frame/SceneFingerprint.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "vtkCommand.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

// Colours from level - window / 2 to level + window / 2 become 0 to 1; a negative window reverses.
glm::dvec2 WindowScaleBias(double window, double level)
{
  constexpr double Narrowest = 1e-6; // of a window: beyond, floats have no colours between
  const double width = std::copysign(std::max(std::abs(window), Narrowest), window);
  return { 1.0 / width, 0.5 - level / width };
}

}

void ChoosePicture(
  vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume, Frame& frame)
{
  const double window = mapper->GetFinalColorWindow();
  const double level = mapper->GetFinalColorLevel();
  frame.settings.windowLevel = window != 1.0 || level != 0.5;
  frame.windowScaleBias = WindowScaleBias(window, level);
  frame.settings.jitter = mapper->GetUseJittering() != 0 && IsSampled(frame.settings);
  frame.imageSampleDistance = mapper->GetImageSampleDistance();

  frame.volume = volume;
  frame.userCode = UserShaderCodeOf(volume);
  frame.volumePass = PassOfVolume(mapper, renderer, volume);
  frame.settings.pass = frame.volumePass.pass;
  frame.toImages = mapper->GetRenderToImage() != 0 && frame.settings.pass == RayPass::Whole;
  frame.clampDepth = mapper->GetClampDepthToBackface() != 0;
  const bool maySeeOther = mapper->HasObserver(vtkCommand::UpdateShaderEvent) != 0;
  const int most = mapper->GetMaximumAccumulatedPictures();
  if (!maySeeOther && (most > 1 || mapper->GetLongestPartSeconds() > 0.0))
  {
    frame.mostAccumulated = most;
    frame.longestPartSeconds = mapper->GetLongestPartSeconds();
    frame.sceneNumbers = NumbersOfScene(mapper, frame);
  }
  if (Peels(frame.settings.pass))
  {
    // The pass has a framebuffer of its own, and the depth of what is opaque.
    frame.viewport = { 0, 0, frame.viewport.width, frame.viewport.height };
    frame.settings.sceneGeometry = false;
  }
}

void UseQuality(const PictureQuality& quality, vtkVariationFieldVolumeMapper* mapper, Frame& frame)
{
  const double least = mapper->GetMinimumImageSampleDistance();
  const double most = std::max<double>(least, mapper->GetMaximumImageSampleDistance());
  frame.imageSampleDistance =
    std::max(frame.imageSampleDistance, std::clamp(quality.imageSampleDistance, least, most));
  frame.mostAccumulated = 0;
  // The field stays: it would have to be built again.
  frame.errorTolerance *= quality.toleranceFactor;
  frame.sampleDistanceMm *= quality.toleranceFactor;
}

}
