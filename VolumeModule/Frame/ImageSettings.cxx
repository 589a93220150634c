#include "Frame/ImageSettings.h"

#include "Frame/MapperNumbers.h"
#include "Frame/SceneFingerprint.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "vtkCommand.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

// Maps colours from level - window / 2 to level + window / 2 to [0, 1]; a negative window inverts.
glm::dvec2 WindowScaleBias(double window, double level)
{
  constexpr double Narrowest = 1e-6; // a narrower window would not contain two floats
  const double width = std::copysign(std::max(std::abs(window), Narrowest), window);
  return { 1.0 / width, 0.5 - level / width };
}

// An observer of the shader may set uniforms that are not part of the fingerprint, so nothing is
// accumulated then.
void ChooseAccumulation(
  vtkVariationFieldVolumeMapper* mapper, const MapperNumbers& numbers, Frame& frame)
{
  const bool shaderIsObserved = mapper->HasObserver(vtkCommand::UpdateShaderEvent) != 0;
  const int most = mapper->GetMaximumAccumulatedPictures();
  if (!shaderIsObserved && (most > 1 || numbers.longestPartSeconds > 0.0))
  {
    frame.accumulation = { most, numbers.longestPartSeconds, ImageFingerprint(mapper, frame) };
  }
}

}

void ApplyImageSettings(
  vtkVariationFieldVolumeMapper* mapper, const MapperNumbers& numbers, Frame& frame)
{
  frame.settings.windowLevel = numbers.window != 1.0 || numbers.level != 0.5;
  frame.settings.jitter = mapper->GetUseJittering() != 0 && IsSampled(frame.settings);
  frame.userCode = UserShaderCodeOf(frame.view.prop);
  frame.pass = PassOfVolume(mapper, frame.view.renderer, frame.view.prop);
  frame.settings.pass = frame.pass.kind;

  const auto& [shortest, longest] = numbers.interactiveSampleDistances;
  frame.image.windowScaleBias = WindowScaleBias(numbers.window, numbers.level);
  frame.image.sampleDistance = numbers.imageSampleDistance;
  frame.image.interactiveSampleDistances = { shortest, std::max(shortest, longest) };
  frame.image.toImages = mapper->GetRenderToImage() != 0 && frame.pass.kind == RayPass::Whole;
  frame.image.clampDepth = mapper->GetClampDepthToBackface() != 0;

  frame.fingerprint = VolumeFingerprint(frame);
  ChooseAccumulation(mapper, numbers, frame);
  if (Peels(frame.pass.kind))
  {
    // The pass has its own framebuffer, and has the depth of opaque geometry.
    frame.view.viewport = { 0, 0, frame.view.viewport.width, frame.view.viewport.height };
    frame.settings.sceneGeometry = false;
  }
}

}
