#include "Scene/Pipeline/ScenePipeline.h"

#include "Scene/Looks/LookRegions.h"
#include "Scene/Looks/VolumeProperty.h"
#include "Scene/Model/SceneCamera.h"
#include "Scene/Model/SceneCuts.h"
#include "Scene/Model/SceneLights.h"
#include "Scene/Segments/BodyMask.h"
#include "Scene/Volumes/ImageOrientation.h"
#include "Scene/Volumes/VolumeColors.h"

#include <vtkCamera.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkTransform.h>
#include <vtkVariationFieldVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <algorithm>

class vtkImageData;
class vtkVolumeMapper;

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
  // By default this mapper adapts its ray spacing to a frame rate, but an image must not depend
  // on the speed of the machine. Its default sample distance is 1 mm for any voxel size.
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(float(DistanceMm(options, image)));
}

/// Gives the options of a scene to a mapper of any MapperKind. VTK's mappers take those that they
/// know.
/// @param image  the volume that the mapper draws
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

constexpr std::array<double, 2> AllValues = { VTK_FLOAT_MIN, VTK_FLOAT_MAX };

vtkSmartPointer<vtkVolumeMapper> NewMapper(MapperKind kind)
{
  switch (kind)
  {
    case MapperKind::VtkGpu:
      return vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New();
    case MapperKind::VtkCpu:
      return vtkSmartPointer<vtkFixedPointVolumeRayCastMapper>::New();
    default:
      auto mapper = vtkSmartPointer<vtkVariationFieldVolumeMapper>::New();
      mapper->SetProcessorMarching(kind == MapperKind::Varimarch);
      mapper->LabelSurfacesOn();
      return mapper;
  }
}

int VtkBlendModeOf(Blend blend)
{
  switch (blend)
  {
    case Blend::MaximumIntensity:
      return vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND;
    case Blend::MinimumIntensity:
      return vtkVolumeMapper::MINIMUM_INTENSITY_BLEND;
    case Blend::AverageIntensity:
      return vtkVolumeMapper::AVERAGE_INTENSITY_BLEND;
    case Blend::Additive:
      return vtkVolumeMapper::ADDITIVE_BLEND;
    case Blend::Isosurface:
      return vtkVolumeMapper::ISOSURFACE_BLEND;
    default:
      return vtkVolumeMapper::COMPOSITE_BLEND;
  }
}

}

bool CanBlend(MapperKind kind, Blend blend)
{
  return kind != MapperKind::VtkCpu ||
    (blend != Blend::AverageIntensity && blend != Blend::Isosurface);
}

bool CanCutByScissors(MapperKind kind)
{
  return kind != MapperKind::VtkCpu;
}

bool CanDrawLabels(MapperKind kind, Blend blend, vtkImageData* image)
{
  return kind != MapperKind::VtkCpu && blend == Blend::Composite &&
    image->GetNumberOfScalarComponents() == 1;
}

bool CanDrawRegions(MapperKind kind, Blend blend, vtkImageData* image)
{
  return CanDrawLabels(kind, blend, image);
}

ScenePipeline::ScenePipeline(const Scene& scene, vtkImageData* image, MapperKind kind)
  : kind(kind)
  , image(image)
  , voxels(ColoredVoxels(image))
  , mapper(NewMapper(kind))
  , overlays(kind, this->mapper, this->volume)
{
  if (IsOurs(kind))
  {
    this->mapper->SetInputDataObject(this->voxels);
  }
  else
  {
    vtkNew<vtkTransform> worldFromImage;
    this->mapper->SetInputDataObject(WithoutDirection(RightHanded(this->voxels), worldFromImage));
    this->volume->SetUserTransform(worldFromImage);
  }
  this->volume->SetMapper(this->mapper);
  this->renderer->AddVolume(this->volume);
  this->SetLook(scene.look);
  this->SetLighting(LightingOf(scene));
  this->SetCuts(scene.cuts);
  this->SetRenderOptions(scene.render);
  this->SetBackground(scene.background);
  this->SetCamera(scene.camera, double(scene.size[0]) / scene.size[1]);
}

void ScenePipeline::SetLook(const Look& newLook)
{
  this->look = InUnitsOfData(newLook, this->image);
  this->ApplyBlend();
  const auto averaged = this->look.averagedRange.value_or(AllValues);
  this->mapper->SetAverageIPScalarRange(averaged[0], averaged[1]);
  if (auto* ours = vtkVariationFieldVolumeMapper::SafeDownCast(this->mapper))
  {
    ours->SetDampingGradient(this->look.dampingGradient * MeanSpacingMm(this->image));
  }
  this->ApplyProperty();
  this->ApplyMask();
  this->ApplyOverlays(); // the segments of the first volume have its shading
}

void ScenePipeline::SetLights(const std::vector<SceneLight>& lights)
{
  varimarch::SetLights(lights, this->renderer);
}

void ScenePipeline::SetLighting(const Lighting& newLighting)
{
  this->lighting = newLighting;
  this->SetLights(this->lighting.lights);
  this->ApplyLight();
}

void ScenePipeline::ApplyBlend()
{
  this->mapper->SetBlendMode(
    this->overlays.Any() ? vtkVolumeMapper::COMPOSITE_BLEND : VtkBlendModeOf(this->look.blend));
}

void ScenePipeline::ApplyLight()
{
  if (auto* ours = vtkVariationFieldVolumeMapper::SafeDownCast(this->mapper))
  {
    ours->SetShadows(this->lighting.shadows > 0.0);
    ours->SetShadowStrength(this->lighting.shadows);
    ours->SetVolumetricScatteringBlending(this->lighting.scattering.blending);
    ours->SetGlobalIlluminationReach(this->lighting.scattering.reach);
    ours->SetScatteringAnisotropy(this->lighting.scattering.anisotropy);
    ours->SetAmbientOcclusion(this->lighting.occlusion.strength);
    ours->SetAmbientOcclusionReach(this->lighting.occlusion.reachMm);
  }
}

void ScenePipeline::SetOverlays(
  const std::vector<OverlaidVolume>& drawn, const std::vector<OverlayVoxels>& voxels)
{
  this->wantedOverlays = drawn;
  this->wantedVoxels = voxels;
  this->ApplyOverlays();
}

void ScenePipeline::ApplyOverlays()
{
  vtkVolume* const before = this->overlays.Prop();
  const bool wasAlone = !this->overlays.Any();
  const bool areDrawn = this->faceDepthMm == 0.0;
  this->overlays.Set(areDrawn ? this->wantedOverlays : std::vector<OverlaidVolume>(),
    this->wantedVoxels,
    { this->labels.get(), this->labelMask, this->segments, this->look.shading });
  if (this->overlays.Prop() != before)
  {
    this->renderer->RemoveVolume(before);
    this->renderer->AddVolume(this->overlays.Prop());
  }
  if (this->overlays.Any() == wasAlone)
  {
    this->ApplyBlend();
    this->ApplyProperty();
    this->ApplyMask();
    this->SetRenderOptions(this->options);
  }
}

void ScenePipeline::SetLabels(std::shared_ptr<const LabelMap> newLabels)
{
  this->labels = std::move(newLabels);
  this->segments = this->labels ? this->labels->segments : std::vector<Segment>();
  this->labelMask = this->labels ? LabelMask(*this->labels, this->mask) : nullptr;
  this->ApplyProperty();
  this->ApplyMask();
  this->ApplyOverlays();
}

void ScenePipeline::SetSegments(const std::vector<Segment>& changed)
{
  this->segments = changed;
  this->ApplyProperty();
  this->ApplyOverlays();
}

bool ScenePipeline::DrawsLabels() const
{
  return this->labels && !this->overlays.Any() &&
    CanDrawLabels(this->kind, this->look.blend, this->image);
}

bool ScenePipeline::DrawsRegions() const
{
  return !this->look.regions.empty() && CanDrawRegions(this->kind, this->look.blend, this->image);
}

// A new property each time: functions of labels cannot be removed from one.
void ScenePipeline::ApplyProperty()
{
  vtkNew<vtkVolumeProperty> property;
  ApplyLook(this->look, this->image, property);
  if (this->DrawsRegions())
  {
    ApplyRegions(this->look.regions, this->image, property);
  }
  if (this->DrawsLabels())
  {
    ApplySegments(*this->labels, this->segments, property);
  }
  this->volume->SetProperty(property);
  this->ApplyInterpolation();
}

void ScenePipeline::ApplyInterpolation()
{
  const bool nearest = this->options.interpolation == Interpolation::Nearest;
  const int type = nearest ? VTK_NEAREST_INTERPOLATION : VTK_LINEAR_INTERPOLATION;
  this->volume->GetProperty()->SetInterpolationType(type);
  this->overlays.SetInterpolationType(type);
  if (auto* ours = vtkVariationFieldVolumeMapper::SafeDownCast(this->mapper))
  {
    ours->SetCubicInterpolation(
      this->options.interpolation == Interpolation::Cubic && this->look.blend != Blend::Isosurface);
  }
}

void ScenePipeline::ApplyMask()
{
  if (this->DrawsLabels())
  {
    this->SetMask(this->labelMask, true);
  }
  else
  {
    this->SetMask(this->overlays.Any() ? nullptr : this->mask.Get(), false);
  }
  this->ApplyFirstImage();
}

// Overlapping volumes have no masks, so a masked first volume has its smallest value where it is
// cut away.
void ScenePipeline::ApplyFirstImage()
{
  vtkImageData* const wanted = this->overlays.Any() ? this->mask.Get() : nullptr;
  if (this->mapperMask != wanted)
  {
    this->mapperMask = wanted;
    this->ApplyVoxels();
  }
}

void ScenePipeline::ApplyVoxels()
{
  const vtkSmartPointer<vtkImageData> drawn =
    this->mapperMask ? WithoutRemoved(this->voxels, this->mapperMask) : this->voxels;
  vtkNew<vtkTransform> unused; // the geometry is the same
  this->mapper->SetInputDataObject(
    0, IsOurs(this->kind) ? drawn : WithoutDirection(RightHanded(drawn), unused));
}

void ScenePipeline::SetImage(vtkImageData* newImage)
{
  this->image = newImage;
  this->voxels = ColoredVoxels(newImage);
  this->ApplyVoxels();
  if (this->DrawsRegions())
  {
    this->ApplyProperty(); // regions cover the range of the values
  }
}

void ScenePipeline::SetMask(vtkImageData* voxels, bool areLabels)
{
  if (auto* ours = vtkVariationFieldVolumeMapper::SafeDownCast(this->mapper))
  {
    ours->SetMaskType(areLabels ? vtkVariationFieldVolumeMapper::LabelMapMaskType
                                : vtkVariationFieldVolumeMapper::BinaryMaskType);
    ours->SetMaskInput(voxels);
  }
  else if (auto* gpu = vtkGPUVolumeRayCastMapper::SafeDownCast(this->mapper))
  {
    gpu->SetMaskType(areLabels ? vtkGPUVolumeRayCastMapper::LabelMapMaskType
                               : vtkGPUVolumeRayCastMapper::BinaryMaskType);
    gpu->SetMaskInput(voxels ? RightHanded(voxels) : nullptr);
  }
}

void ScenePipeline::SetCamera(const Camera& camera, double aspect)
{
  PlaceCamera(camera, this->image->GetBounds(), aspect, this->renderer->GetActiveCamera());
  if (camera.clippingRangeMm)
  {
    this->renderer->GetActiveCamera()->SetClippingRange(camera.clippingRangeMm->data());
  }
  else
  {
    this->renderer->ResetCameraClippingRange();
  }
}

void ScenePipeline::SetCuts(const SceneCuts& cuts)
{
  vtkNew<vtkPlaneCollection> planes;
  for (const CutPlane& cut : PlanesOf(cuts, this->image))
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(cut.pointMm.data());
    plane->SetNormal(cut.normal.data());
    planes->AddItem(plane);
  }
  this->mapper->SetClippingPlanes(planes);
  // Making a mask visits every voxel; dragging a plane must not repeat that.
  if (this->scissors != cuts.scissors || this->bodyOnly != cuts.bodyOnly ||
    this->faceDepthMm != cuts.faceDepthMm)
  {
    this->MakeMask(cuts);
  }
}

void ScenePipeline::MakeMask(const SceneCuts& cuts)
{
  this->scissors = cuts.scissors;
  this->bodyOnly = cuts.bodyOnly;
  if (this->bodyOnly && !this->body)
  {
    this->body = BodyMask(this->image);
  }
  this->faceDepthMm = cuts.faceDepthMm;
  vtkSmartPointer<vtkImageData> stays = this->bodyOnly ? this->body : nullptr;
  if (this->faceDepthMm > 0.0)
  {
    stays = Both(FaceMask(this->image, this->faceDepthMm), stays, this->image);
  }
  this->mask = MaskOf(cuts.scissors, this->image, stays);
  this->labelMask = this->labels ? LabelMask(*this->labels, this->mask) : nullptr;
  this->ApplyMask();
  this->ApplyOverlays();
}

void ScenePipeline::SetRenderOptions(const RenderOptions& newOptions)
{
  this->options = newOptions;
  RenderOptions possible = newOptions;
  possible.mostSteps = this->overlays.Any() ? 0 : newOptions.mostSteps;
  Apply(possible, this->image, this->mapper);
  this->ApplyInterpolation();
}

void ScenePipeline::SetBackground(const std::array<double, 3>& rgb)
{
  this->renderer->SetBackground(rgb[0], rgb[1], rgb[2]);
}

double ScenePipeline::UsedSampleDistanceMm() const
{
  if (auto* ours = vtkVariationFieldVolumeMapper::SafeDownCast(this->mapper))
  {
    return ours->GetUsedSampleDistance();
  }
  if (auto* gpu = vtkGPUVolumeRayCastMapper::SafeDownCast(this->mapper))
  {
    // VTK's mapper does not report the distance that it chose; this is its rule.
    const double* spacing = this->image->GetSpacing();
    return gpu->GetAutoAdjustSampleDistances() ? std::min({ spacing[0], spacing[1], spacing[2] })
                                               : gpu->GetSampleDistance();
  }
  return vtkFixedPointVolumeRayCastMapper::SafeDownCast(this->mapper)->GetSampleDistance();
}

}
