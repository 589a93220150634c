#include "Frame/FrameBuilder.h"

#include "Core/Look/TransferFunction.h"
#include "Core/Recipe/ShaderRecipe.h"
#include "Frame/Lights.h"
#include "Frame/MapperInput.h"
#include "Frame/MaterialChoices.h"
#include "Frame/OverlappingVolumes.h"
#include "Frame/PictureChoices.h"
#include "Frame/UserShaderCode.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImplicitFunction.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <stdexcept>

namespace varimarch
{

namespace
{

bool HasOpaqueGeometry(vtkRenderer* renderer)
{
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    // vtkVolume does not override HasOpaqueGeometry, whose default is yes.
    if (prop->GetVisibility() && !vtkVolume::SafeDownCast(prop) && prop->HasOpaqueGeometry())
    {
      return true;
    }
  }
  // Another renderer's geometry, in a layer below this one.
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
  // A walk from voxel to voxel does not count the length that it leaves out.
  const bool sums = IsProjection(settings.blend) && !settings.nearest;
  switch (accelerationMode)
  {
    case vtkVariationFieldVolumeMapper::ScalarField:
      // Where values are not sampled, their variation says nothing; nor does it of several scalars.
      return one && IsSampled(settings) ? Acceleration::ScalarField : Acceleration::Off;
    case vtkVariationFieldVolumeMapper::OpticalField:
      // A projection of several components is one of each, so that a brick could be left only where
      // that changes none of them. A slice is read but once.
      return settings.blend == Blend::Composite || settings.blend == Blend::Isosurface ||
          (one && (IsExtreme(settings.blend) || sums))
        ? Acceleration::OpticalField
        : Acceleration::Off;
  }
  return Acceleration::Off;
}

Integration IntegrationOf(int integrationRule)
{
  switch (integrationRule)
  {
    case vtkVariationFieldVolumeMapper::PreIntegrated:
      return Integration::PreIntegrated;
    case vtkVariationFieldVolumeMapper::Simpson:
      return Integration::Simpson;
    case vtkVariationFieldVolumeMapper::PublishedSum:
      return Integration::PublishedSum;
  }
  return Integration::Midpoint;
}

// Samples per voxel that keep a composite within half a grey level of a fine march, measured on a
// head CT with a bone transfer function. Normals turn faster than values change; a maximum needs
// no more than to pass close by.
double AutomaticSamplesPerVoxel(const RenderSettings& settings)
{
  if (settings.blend != Blend::Composite)
  {
    return 2.0;
  }
  return MarchesMaterial(settings) ? 8.0 : 4.0;
}

// A homogeneous material as a transfer function of one node would have it.
glm::dvec4 GapOptical(const double color[3], double opacity, double unitDistanceMm)
{
  const TransferFunction material(
    { { 0.0, { color[0], color[1], color[2] } } }, { { 0.0, opacity } }, unitDistanceMm);
  const double extinction = std::min(material.Extinction(0.0), double(OpaqueExtinction));
  return glm::dvec4(material.Color(0.0), extinction);
}

void ChooseSampling(vtkVariationFieldVolumeMapper* mapper, Frame& frame)
{
  // Of the tolerance, the field and the early end of rays may use an eighth each.
  constexpr double Share = 1.0 / 8.0;
  const double fieldErrorWithoutTolerance = IsExtreme(frame.settings.blend) ? 0.0 : 1.0 / 255.0;
  frame.settings.integration = IntegrationOf(mapper->GetIntegrationRule());
  frame.chooseIntegration =
    mapper->GetIntegrationRule() == vtkVariationFieldVolumeMapper::Automatic &&
    frame.settings.blend == Blend::Composite && IsSampled(frame.settings);
  frame.variationTolerance = mapper->GetVariationTolerance();
  frame.errorTolerance = mapper->GetAutoAdjustSampleDistances() ? mapper->GetErrorTolerance() : 0.0;
  const bool tolerance = frame.errorTolerance > 0.0;
  // A window narrower than all colours magnifies their errors.
  const double share = Share / std::max(1.0, std::abs(frame.windowScaleBias.x));
  frame.fieldError = tolerance ? share * frame.errorTolerance : fieldErrorWithoutTolerance;
  frame.earlyTerminationTransmittance =
    tolerance ? share * frame.errorTolerance : mapper->GetEarlyTerminationTransmittance();
  // What is exact has no steps to try out.
  frame.errorTolerance = IsSampled(frame.settings) ? frame.errorTolerance : 0.0;
  if (frame.chooseIntegration && MarchesMaterial(frame.settings) && frame.errorTolerance == 0.0)
  {
    // The rule that errs less at the short steps which nobody has tried out.
    frame.settings.integration = Integration::PreIntegrated;
  }
  frame.sampleDistanceMm = mapper->GetAutoAdjustSampleDistances()
    ? frame.geometry.SmallestSpacingMm() / AutomaticSamplesPerVoxel(frame.settings)
    : mapper->GetSampleDistance();
}

bool HasComponents(vtkVariationFieldVolumeMapper* mapper, int port)
{
  const std::optional<MapperInput> input = InputOf(mapper, port);
  return input && input->scalars->GetNumberOfComponents() > 1;
}

RenderSettings SettingsOf(vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer,
  vtkVolumeProperty* property, vtkDataArray* scalars)
{
  RenderSettings settings;
  settings.blend = BlendOf(mapper->GetBlendMode());
  settings.nearest = property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION;
  settings.cubic = mapper->GetCubicInterpolation() != 0 && !settings.nearest;
  ChooseMaterial(mapper, property, scalars, settings);
  settings.acceleration = AccelerationOf(mapper->GetAccelerationMode(), settings);
  settings.shading = property->GetShade() != 0 && !IsProjection(settings.blend);
  settings.lights = settings.shading && !HasHeadLightOnly(renderer);
  settings.damping = settings.shading && settings.components == Components::One &&
    mapper->GetDampingGradient() > 0.0;
  settings.countFetches = mapper->GetDrawFetchCounts();
  settings.sceneGeometry = HasOpaqueGeometry(renderer);
  settings.fillGaps = mapper->GetNanOpacity() > 0.0;
  return settings;
}

// None where no flag says anything.
vtkUnsignedCharArray* FlagsIn(vtkUnsignedCharArray* flags)
{
  return flags && flags->GetNumberOfTuples() > 0 && flags->GetRange()[1] > 0.0 ? flags : nullptr;
}

// Ascending, each once.
std::vector<double> IsovaluesOf(vtkVolumeProperty* property)
{
  vtkContourValues* const contours = property->GetIsoSurfaceValues();
  const double* const values = contours->GetValues();
  std::set<double> isovalues;
  std::copy_if(values, values + contours->GetNumberOfContours(),
    std::inserter(isovalues, isovalues.end()), [](double value) { return std::isfinite(value); });
  return { isovalues.begin(), isovalues.end() };
}

// The surfaces that a frame draws. False when there are none.
bool ChooseSurfaces(Frame& frame)
{
  if (frame.settings.blend == Blend::Isosurface)
  {
    ChooseSurfaceComponent(frame);
    if (frame.settings.cubic)
    {
      throw std::runtime_error("Isosurfaces of cubic interpolation are not supported");
    }
    frame.isovalues = IsovaluesOf(frame.property);
    return !frame.isovalues.empty();
  }
  if (frame.settings.blend == Blend::Slice)
  {
    vtkImplicitFunction* const function = frame.property->GetSliceFunction();
    frame.slice = function ? SliceSurfaceOf(function, frame.geometry) : SliceSurface();
    // A slice in a face of the volume is in the volume, whatever rounding says.
    constexpr double ReachVoxels = 3e-4;
    frame.geometry.boxGrid.lower -= ReachVoxels;
    frame.geometry.boxGrid.upper += ReachVoxels;
    return function != nullptr;
  }
  return true;
}

// Where voxels are, and which of them are left out.
void ChoosePlaces(const MapperInput& input, vtkVolume* volume, Frame& frame)
{
  frame.axes = input.Axes(frame.settings.nearest);
  frame.geometry = input.Geometry(volume, frame.axes);
  frame.blanking = { FlagsIn(input.data->GetPointGhostArray()),
    FlagsIn(input.data->GetCellGhostArray()), input.PointCount(), input.place,
    frame.settings.nearest };
  if (frame.axes.empty())
  {
    return;
  }
  if (frame.settings.blend == Blend::Isosurface)
  {
    throw std::runtime_error("Isosurfaces of rectilinear grids are not supported");
  }
  if (frame.blanking.Any())
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
  if (frame.settings.acceleration == Acceleration::ScalarField)
  {
    frame.settings.acceleration = Acceleration::Off; // it is of cells of an even grid
  }
}

void ChooseCuts(vtkVariationFieldVolumeMapper* mapper, Frame& frame)
{
  const bool seesCuts = frame.property->GetUseClippedVoxelIntensity() != 0 &&
    frame.settings.components == Components::One;
  frame.cuts = CutsOf(mapper, frame.geometry, seesCuts);
  frame.settings.clipping = !frame.cuts.planesGrid.empty();
  frame.settings.clippedGradients = seesCuts && frame.settings.clipping;
  frame.settings.cropping = frame.cuts.regions.has_value();
}

// Where some scalars do not count in an average, neither does the length of what has them: a ray
// must look at it even where it is invisible.
void ChooseAveraged(vtkVariationFieldVolumeMapper* mapper, Frame& frame)
{
  const double* averaged = mapper->GetAverageIPScalarRange();
  frame.averagedRange = { averaged[0], averaged[1] };
  const double* scalars = frame.scalars->GetFiniteRange();
  // A spline goes beyond its voxels, by less than these differ.
  const double beyond = frame.settings.cubic ? scalars[1] - scalars[0] : 0.0;
  const bool allCount = averaged[0] <= scalars[0] - beyond && scalars[1] + beyond <= averaged[1];
  if (frame.settings.blend == Blend::AverageIntensity && !allCount &&
    frame.settings.acceleration == Acceleration::OpticalField)
  {
    frame.settings.acceleration = Acceleration::Off;
  }
}

// One of the volumes of a prop, which itself is that volume where it has no more.
std::optional<Frame> FrameOfVolume(vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer,
  vtkVolume* prop, const VolumeOfPort& one)
{
  vtkVolume* const volume = one.volume;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    throw std::runtime_error("The render window does not use OpenGL");
  }
  const std::optional<MapperInput> input = InputOf(mapper, one.port);
  if (!input)
  {
    return std::nullopt;
  }
  Frame frame = {};
  frame.window = window;
  frame.renderer = renderer;
  frame.property = volume->GetProperty();
  frame.scalars = input->scalars;
  frame.scalarsTime = std::max(input->data->GetMTime(), input->scalars->GetMTime());
  frame.viewport = ViewportOf(renderer);
  frame.settings = SettingsOf(mapper, renderer, frame.property, input->scalars);
  ChoosePlaces(*input, volume, frame);
  ChooseVoxels(mapper, input->data, frame);
  if (!ChooseSurfaces(frame))
  {
    return std::nullopt;
  }
  frame.dampingGradient = mapper->GetDampingGradient();
  ChooseCuts(mapper, frame);
  ChooseAveraged(mapper, frame);
  frame.gapOptical = GapOptical(
    mapper->GetNanColor(), mapper->GetNanOpacity(), frame.property->GetScalarOpacityUnitDistance());
  frame.mayMarchByProcessor = mapper->GetProcessorMarching() != 0;
  frame.mostMemoryBytes = std::size_t(mapper->GetMaximumGraphicsMemory());
  ChoosePicture(mapper, renderer, prop, frame);
  ChooseSampling(mapper, frame);
  return frame;
}

}

std::optional<Frame> FrameOf(
  vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  std::vector<Frame> frames;
  for (const VolumeOfPort& one : VolumesOfPorts(mapper, volume))
  {
    if (std::optional<Frame> frame = FrameOfVolume(mapper, renderer, volume, one))
    {
      frames.push_back(std::move(*frame));
    }
  }
  return frames.size() > 1 ? JoinedFrame(std::move(frames), mapper)
    : frames.empty()       ? std::nullopt
                           : std::optional<Frame>(std::move(frames.front()));
}

std::string MissingFeatures(vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume)
{
  bool twoValues = false;
  bool labels = false;
  for (const VolumeOfPort& one : VolumesOfPorts(mapper, volume))
  {
    const bool hasComponents = HasComponents(mapper, one.port);
    const int mode = one.volume->GetProperty()->GetTransferFunctionMode();
    twoValues = twoValues ||
      (mode == vtkVolumeProperty::TF_2D &&
        (mapper->GetBlendMode() != vtkVolumeMapper::COMPOSITE_BLEND || hasComponents));
    labels = labels ||
      (mapper->GetMaskInput() && hasComponents &&
        mapper->GetMaskType() == vtkVariationFieldVolumeMapper::LabelMapMaskType);
  }
  std::string missing;
  if (twoValues)
  {
    missing += "Transfer functions of two values are supported for composites of one component. ";
  }
  if (labels)
  {
    missing += "Label maps are supported for volumes of one component. ";
  }
  return missing + MissingShaderCode(volume);
}

std::string UnsupportedFeature(
  vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  try
  {
    FrameOf(mapper, renderer, volume);
  }
  catch (const std::exception& problem)
  {
    return problem.what();
  }
  return MissingFeatures(mapper, volume);
}

}
