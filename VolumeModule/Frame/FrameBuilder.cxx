#include "Frame/FrameBuilder.h"

#include "Core/Look/OpticalTable.h"
#include "Core/Recipe/MaterialRecipe.h"
#include "Frame/Frame.h"
#include "Frame/MapperInput.h"
#include "Frame/MapperNumbers.h"
#include "Frame/MaterialChoices.h"
#include "Frame/NumberCheck.h"
#include "Frame/OverlappingVolumes.h"
#include "Frame/SceneFingerprint.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cmath>
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

/// Refuses a published integration rule for a composite that it does not define, in whose place
/// another rule would be drawn.
/// @param settings  those of all volumes of a frame
/// @throws std::runtime_error with a sentence for the user
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

/// Chooses the error budget, the sample distance and the integration rule of a frame whose other
/// settings are complete.
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

/// Chooses the part of rays that is marched.
// A number of steps has a meaning only if these are of known length.
void ChooseSpan(vtkVariationFieldVolumeMapper* mapper, const MapperNumbers& numbers, Frame& frame)
{
  frame.span.firstDistanceMm = numbers.firstDistanceMm;
  frame.span.mostSteps =
    mapper->GetAutoAdjustSampleDistances() ? 0 : mapper->GetMaximumNumberOfSteps();
  frame.settings.limitsSpan = frame.span.firstDistanceMm > 0.0 || frame.span.mostSteps > 0;
}

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

/// Takes the settings of the image from a mapper: window and level, the distance between rays and
/// their jitter, the requested pass, accumulation, and the user's shader code. Requires the view.
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
  if (mapper->GetLevelOfDetail() == vtkVariationFieldVolumeMapper::RefinedLevel)
  {
    frame.refinement = ImageFingerprint(mapper, frame);
  }
}

bool HasOpaqueGeometry(vtkRenderer* renderer)
{
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    // vtkVolume does not override HasOpaqueGeometry, which returns true by default.
    if (prop->GetVisibility() && !vtkVolume::SafeDownCast(prop) && prop->HasOpaqueGeometry())
    {
      return true;
    }
  }
  // A preserved depth buffer has the geometry of a renderer in a lower layer.
  return renderer->GetPreserveDepthBuffer() != 0;
}

Blend BlendOf(int blendMode)
{
  switch (blendMode)
  {
    case vtkVolumeMapper::COMPOSITE_BLEND:
      return Blend::Composite;
    case vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND:
      return Blend::MaximumIntensity;
    case vtkVolumeMapper::MINIMUM_INTENSITY_BLEND:
      return Blend::MinimumIntensity;
    case vtkVolumeMapper::AVERAGE_INTENSITY_BLEND:
      return Blend::AverageIntensity;
    case vtkVolumeMapper::ADDITIVE_BLEND:
      return Blend::Additive;
    case vtkVolumeMapper::ISOSURFACE_BLEND:
      return Blend::Isosurface;
    case vtkVolumeMapper::SLICE_BLEND:
      return Blend::Slice;
  }
  throw std::runtime_error("Blend mode " + std::to_string(blendMode) +
    " is not supported: expected composite (0), maximum (1), minimum (2) or average intensity (3), "
    "additive (4), isosurface (5) or slice (6)");
}

Acceleration AccelerationOf(int accelerationMode, const RenderSettings& settings)
{
  const bool one = settings.components == Components::One;
  // A walk from voxel to voxel cannot add up the lengths that it skips.
  const bool sums = IsProjection(settings.blend) && !settings.nearest;
  if (settings.fromBehind)
  {
    return Acceleration::Off; // the length of a step depends on what lies in front of it
  }
  switch (accelerationMode)
  {
    case vtkVariationFieldVolumeMapper::CellField:
      // The cell field describes interpolated values of one component only.
      return one && IsSampled(settings) ? Acceleration::CellField : Acceleration::Off;
    case vtkVariationFieldVolumeMapper::VariationField:
      // Coefficients of a spline are not values.
      return one && IsSampled(settings) && !settings.cubic ? Acceleration::VariationField
                                                           : Acceleration::Off;
    case vtkVariationFieldVolumeMapper::OpticalField:
      // A projection of several components has a result for each of them, and a brick could be
      // skipped only if it changed none. A slice is sampled only once per ray.
      return settings.blend == Blend::Composite || settings.blend == Blend::Isosurface ||
          (one && (IsExtreme(settings.blend) || sums))
        ? Acceleration::OpticalField
        : Acceleration::Off;
  }
  return Acceleration::Off;
}

// The homogeneous material of a transfer function with one node.
glm::dvec4 GapOptical(const glm::dvec3& color, double opacity, double unitDistanceMm)
{
  const TransferFunction material({ { 0.0, color } }, { { 0.0, opacity } }, unitDistanceMm);
  const double extinction = std::min(material.Extinction(0.0), double(OpaqueExtinction));
  return glm::dvec4(material.Color(0.0), extinction);
}

// Requires the voxels and the lights.
RenderSettings SettingsOf(vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer,
  vtkVolumeProperty* property, const MapperNumbers& numbers, const Frame& frame)
{
  RenderSettings settings;
  settings.blend = BlendOf(mapper->GetBlendMode());
  settings.nearest = property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION;
  settings.cubic = mapper->GetCubicInterpolation() != 0 && !settings.nearest;
  ChooseMaterial(mapper, property, frame.voxels.scalars, settings);
  settings.fromBehind = settings.blend == Blend::Composite && !settings.nearest &&
    mapper->GetCompositingOrder() == vtkVariationFieldVolumeMapper::BackToFront;
  settings.acceleration = AccelerationOf(mapper->GetAccelerationMode(), settings);
  settings.shading = property->GetShade() != 0 && !IsProjection(settings.blend);
  settings.scattering =
    settings.shading && settings.blend == Blend::Composite && numbers.scatteringBlending > 0.0;
  settings.lights = settings.shading && (settings.scattering || !frame.lights.AreUsual());
  const bool dimsScattered = settings.scattering && numbers.illuminationReach > 0.0;
  const bool hasShadows = mapper->GetShadows() != 0 && numbers.shadowStrength > 0.0;
  const bool dims =
    settings.lights && settings.blend == Blend::Composite && (hasShadows || dimsScattered);
  const LightTexels dimmed = dims ? frame.lights.lamps : LightTexels();
  settings.shadows = dimmed.Count() > 0;
  settings.softLights = RaysToLights(dimmed) > dimmed.Count();
  settings.occlusion = settings.blend == Blend::Composite && numbers.occlusion > 0.0;
  settings.damping =
    settings.shading && settings.components == Components::One && numbers.dampingGradient > 0.0;
  settings.countFetches = mapper->GetDrawFetchCounts();
  settings.sceneGeometry = HasOpaqueGeometry(renderer);
  settings.fillGaps = numbers.nanOpacity > 0.0;
  return settings;
}

// The flags, or null if none is set.
vtkUnsignedCharArray* FlagsIn(vtkUnsignedCharArray* flags)
{
  return flags && flags->GetNumberOfTuples() > 0 && flags->GetRange()[1] > 0.0 ? flags : nullptr;
}

// Chooses the positions of the voxels, and the blanked ones.
void ChoosePlaces(const MapperInput& input, vtkVolume* volume, Frame& frame)
{
  frame.voxels.axes = input.Axes(frame.settings.nearest);
  frame.geometry = input.Geometry(volume, frame.voxels.axes);
  CheckPlaces(frame.geometry);
  frame.voxels.blanking = { FlagsIn(input.data->GetPointGhostArray()),
    FlagsIn(input.data->GetCellGhostArray()), input.PointCount(), input.place,
    frame.settings.nearest };
  if (frame.voxels.axes.empty())
  {
    return;
  }
  if (frame.settings.blend == Blend::Isosurface)
  {
    throw std::runtime_error("Isosurfaces of rectilinear grids are not supported");
  }
  if (frame.voxels.blanking.Any())
  {
    throw std::runtime_error("Blanked parts of rectilinear grids are not supported");
  }
  if (frame.settings.cubic)
  {
    throw std::runtime_error("Cubic interpolation of rectilinear grids is not supported");
  }
  if (frame.settings.mask != Mask::None)
  {
    throw std::runtime_error("Masks of rectilinear grids are not supported");
  }
  frame.settings.uneven = true;
  if (IsOfValues(frame.settings.acceleration))
  {
    frame.settings.acceleration = Acceleration::Off; // fields need cells of equal size
  }
}

void ChooseCuts(vtkVariationFieldVolumeMapper* mapper, vtkVolumeProperty* property,
  NumberCheck& check, Frame& frame)
{
  const bool seesCuts =
    property->GetUseClippedVoxelIntensity() != 0 && frame.settings.components == Components::One;
  frame.cuts = CutsOf(mapper, frame.geometry, seesCuts, check);
  frame.settings.clipping = !frame.cuts.planesGrid.empty();
  frame.settings.clippedGradients = seesCuts && frame.settings.clipping;
  frame.settings.cropping = frame.cuts.regions.has_value();
}

// Light that is scattered is dimmed without Shadows too, but by volumes alone.
void ChooseCasters(
  vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* prop, Frame& frame)
{
  if (frame.settings.shadows && frame.material.surfacesInShadow > 0.0)
  {
    frame.casters = ShadowCastersOf(mapper, renderer, prop);
    frame.settings.casters = !frame.casters.surfaces.empty();
  }
}

// Rays through scalars that do not count in an average must be sampled, although invisible.
void ChooseAveraged(const MapperNumbers& numbers, Frame& frame)
{
  const std::array<double, 2>& averaged = numbers.averagedRange;
  frame.material.averagedRange = averaged;
  if (frame.settings.blend != Blend::AverageIntensity)
  {
    return;
  }
  const double* scalars = frame.voxels.scalars->GetFiniteRange();
  // A spline exceeds the range of its voxels by less than the width of that range.
  const double beyond = frame.settings.cubic ? scalars[1] - scalars[0] : 0.0;
  const bool allCount = averaged[0] <= scalars[0] - beyond && scalars[1] + beyond <= averaged[1];
  const bool hasCubics = frame.settings.components == Components::One &&
    !(frame.settings.nearest || frame.settings.cubic || frame.settings.uneven);
  frame.settings.limitsMean = hasCubics && !allCount;
  const bool isOptical = frame.settings.acceleration == Acceleration::OpticalField;
  if (frame.settings.limitsMean || (isOptical && !allCount))
  {
    frame.settings.acceleration = Acceleration::Off;
  }
}

DeviceRequest DeviceOf(vtkVariationFieldVolumeMapper* mapper)
{
  DeviceRequest device;
  device.mostMemoryBytes = std::size_t(mapper->GetMaximumGraphicsMemory());
  device.mostHostBytes = std::size_t(mapper->GetMaximumHostMemory());
  device.mayMarchOnProcessor = mapper->GetProcessorMarching() != 0;
  return device;
}

// Requires a window that uses OpenGL.
FrameView ViewOf(vtkOpenGLRenderWindow* window, vtkRenderer* renderer, vtkVolume* prop)
{
  const Viewport viewport = ViewportOf(renderer);
  vtkCamera* const camera = renderer->GetActiveCamera();
  return { window, renderer, prop, viewport, viewport, ClipFromWorld(renderer),
    glm::make_vec3(camera->GetPosition()), glm::make_vec3(camera->GetDirectionOfProjection()),
    camera->GetLeftEye() != 0 };
}

// Requires everything that volumes that overlap share.
void TakeFingerprints(Frame& frame)
{
  frame.extinction = ExtinctionFingerprint(frame);
  frame.unlit = UnlitFingerprint(frame);
}

// Builds the frame of one volume of a prop. A prop with one volume is that volume itself.
std::optional<Frame> BuildFrameOfVolume(vtkVariationFieldVolumeMapper* mapper,
  vtkRenderer* renderer, vtkVolume* prop, const VolumeOfPort& one, vtkImageData* instead)
{
  vtkVolume* const volume = one.volume;
  vtkVolumeProperty* const property = volume->GetProperty();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    throw std::runtime_error("The render window does not use OpenGL");
  }
  const Viewport viewport = ViewportOf(renderer);
  const std::optional<MapperInput> input = instead ? InputOf(instead) : InputOf(mapper, one.port);
  if (!input || viewport.width < 1 || viewport.height < 1)
  {
    return std::nullopt;
  }
  NumberCheck check;
  const MapperNumbers numbers = MapperNumbersOf(mapper, check);
  Frame frame = {};
  frame.view = ViewOf(window, renderer, prop);
  frame.voxels.scalars = input->scalars;
  frame.voxels.time = input->Time();
  TakeProperty(property, check, frame.material);
  frame.lights = LightsOf(renderer, check);
  frame.settings = SettingsOf(mapper, renderer, property, numbers, frame);
  ChoosePlaces(*input, volume, frame);
  CheckView(renderer);
  ChooseVoxels(mapper, property, input->data, frame);
  if (!ChooseSurfaces(property, frame))
  {
    return std::nullopt;
  }
  ChooseLight(mapper, numbers, frame);
  ChooseCasters(mapper, renderer, prop, frame);
  ChooseCuts(mapper, property, check, frame);
  ChooseAveraged(numbers, frame);
  frame.material.gapOptical =
    GapOptical(numbers.nanColor, numbers.nanOpacity, property->GetScalarOpacityUnitDistance());
  frame.material.functions =
    MaterialFunctionsOf(property, frame.settings, frame.material.surfaceComponent);
  frame.device = DeviceOf(mapper);
  ApplyImageSettings(mapper, numbers, frame);
  ChooseQuality(mapper, numbers, frame);
  ChooseSpan(mapper, numbers, frame);
  frame.replacedNumbers = check.Notes();
  return frame;
}

}

std::optional<Frame> BuildFrame(vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer,
  vtkVolume* volume, vtkImageData* instead)
{
  std::vector<Frame> frames;
  for (const VolumeOfPort& one : VolumesOfPorts(mapper, volume))
  {
    if (std::optional<Frame> frame = BuildFrameOfVolume(mapper, renderer, volume, one, instead))
    {
      frames.push_back(std::move(*frame));
    }
  }
  if (frames.empty())
  {
    return std::nullopt;
  }
  Frame frame =
    frames.size() > 1 ? JoinFrames(std::move(frames), mapper) : std::move(frames.front());
  CheckIntegrationRule(mapper, frame.settings);
  TakeFingerprints(frame);
  std::for_each(frame.others.begin(), frame.others.end(), TakeFingerprints);
  return frame;
}

}
