#include "SceneArguments.h"

#include "Scene/BodyMask.h"
#include "Scene/ImageStatistics.h"
#include "Scene/LabelMap.h"
#include "Scene/LookFiles.h"
#include "Scene/PresetSuggestion.h"
#include "Scene/Presets.h"
#include "Scene/SceneFile.h"
#include "Scene/SceneLights.h"
#include "Scene/VolumeProperty.h"
#include "UsageError.h"

namespace varimarch
{

namespace
{

Preset Suggested(const LoadedVolume& volume, const ImageStatistics& statistics)
{
  return volume.segments.empty() ? BuiltInPreset(SuggestedPreset(volume, statistics).name)
                                 : Preset{ LookOfLabelsOnly() };
}

/// The look of a file. Colours without opacities get those of the scene, or those of the preset
/// that is suggested for a volume without a scene.
Preset PresetOfFile(
  const SceneArguments& arguments, const LoadedVolume& volume, const Look& ofScene)
{
  const ImageStatistics statistics(volume.image);
  const bool hasScene = !ofScene.opacities.empty();
  LookContext context = ContextOf(volume.image);
  context.opacities =
    InUnitsOfData(hasScene ? ofScene : Suggested(volume, statistics).look, statistics).opacities;
  return ReadLook(arguments.transferFunction, arguments.lookName, context);
}

/// The preset that the arguments name, or for a volume without a scene the suggested one.
std::optional<Preset> ChosenPreset(
  const SceneArguments& arguments, const LoadedVolume& volume, bool isScene, const Scene& scene)
{
  if (!arguments.transferFunction.empty())
  {
    return PresetOfFile(arguments, volume, scene.look);
  }
  if (!arguments.preset.empty())
  {
    return BuiltInPreset(arguments.preset);
  }
  return isScene ? std::nullopt : std::optional(Suggested(volume, ImageStatistics(volume.image)));
}

void OverridePreset(
  const SceneArguments& arguments, const std::optional<Preset>& preset, Scene& scene)
{
  if (preset)
  {
    TakePreset(*preset, scene);
  }
  if (!arguments.presetLight)
  {
    return;
  }
  if (!preset || !preset->light)
  {
    throw UsageError("--preset-light: expected a preset that has a light, found " +
      (scene.look.name.empty() ? std::string("a look without a name") : scene.look.name) +
      "; use --light and --shadows instead");
  }
  TakeLighting(*preset->light, scene);
}

void OverrideLook(const SceneArguments& arguments, Look& look)
{
  if (!arguments.regions.empty())
  {
    look.regions = ReadRegions(arguments.regions);
  }
  look.shading.enabled = arguments.shade.value_or(look.shading.enabled);
  look.dampingGradient = arguments.dampingGradient.value_or(look.dampingGradient);
  if (arguments.blend)
  {
    look.blend = *arguments.blend;
    if (look.blend == Blend::Isosurface && look.isosurfaces.empty())
    {
      throw UsageError("--blend: isosurface needs a look that has isosurfaces");
    }
  }
}

void OverrideCamera(const SceneArguments& arguments, Camera& camera)
{
  camera.view = arguments.view.value_or(camera.view);
  camera.azimuthDegrees = arguments.azimuthDegrees.value_or(camera.azimuthDegrees);
  camera.elevationDegrees = arguments.elevationDegrees.value_or(camera.elevationDegrees);
  camera.zoom = arguments.zoom.value_or(camera.zoom);
  camera.parallel = arguments.parallel || camera.parallel;
  if (arguments.clippingRangeMm)
  {
    if (!((*arguments.clippingRangeMm)[0] < (*arguments.clippingRangeMm)[1]))
    {
      throw UsageError("--clipping-range: expected the nearer distance first");
    }
    camera.clippingRangeMm = arguments.clippingRangeMm;
  }
}

void OverrideSampling(const SceneArguments& arguments, RenderOptions& render)
{
  if (arguments.sampleDistanceMm)
  {
    render.sampleDistanceMm = arguments.sampleDistanceMm;
    render.sampleDistanceVoxels.reset();
  }
  render.errorTolerance = arguments.errorTolerance.value_or(render.errorTolerance);
  render.acceleration = arguments.acceleration.value_or(render.acceleration);
  if (arguments.integration)
  {
    render.integration = arguments.integration;
  }
  if (arguments.variationTolerance)
  {
    render.variationTolerance = arguments.variationTolerance;
  }
  render.earlyTerminationTransmittance =
    arguments.earlyTerminationTransmittance.value_or(render.earlyTerminationTransmittance);
  render.level = arguments.level.value_or(render.level);
  render.interpolation = arguments.interpolation.value_or(render.interpolation);
  render.jitter = arguments.jitter || render.jitter;
  if (arguments.sampleDistanceVoxels)
  {
    render.sampleDistanceVoxels = arguments.sampleDistanceVoxels;
  }
  render.mostSteps = arguments.mostSteps.value_or(render.mostSteps);
  render.firstDistanceMm = arguments.firstDistanceMm.value_or(render.firstDistanceMm);
}

}

std::pair<Scene, LoadedVolume> LoadScene(
  const SceneArguments& arguments, const std::string& input, bool mayBePreview)
{
  const bool isScene = IsSceneFile(input);
  if (isScene)
  {
    RejectFileArguments(arguments.volume, "scene file");
  }
  Scene scene = isScene ? ReadScene(input) : Scene();
  scene.volume =
    isScene ? Override(arguments.volume, scene.volume) : SourceOf(arguments.volume, input);
  const bool isCoarse = arguments.level.value_or(scene.render.level) == VolumeLevel::Coarse;
  // Labels lie on the voxels of the volume itself.
  LoadedVolume loaded =
    LoadVolumeReporting(scene.volume, mayBePreview && isCoarse && !scene.labels);
  OverridePreset(arguments, ChosenPreset(arguments, loaded, isScene, scene), scene);
  OverrideLook(arguments, scene.look);
  scene.lights = arguments.lights.empty() ? scene.lights : arguments.lights;
  for (SceneLight& light : scene.lights)
  {
    const double softness = arguments.softnessDegrees.value_or(light.softnessDegrees);
    light.softnessDegrees = light.kind == LightKind::Head ? 0.0 : softness;
  }
  scene.shadows = arguments.shadows.value_or(scene.shadows);
  scene.scattering = { arguments.scattering.value_or(scene.scattering.blending),
    arguments.anisotropy.value_or(scene.scattering.anisotropy),
    arguments.scatteringReach.value_or(scene.scattering.reach) };
  scene.occlusion = { arguments.occlusion.value_or(scene.occlusion.strength),
    arguments.occlusionReachMm.value_or(scene.occlusion.reachMm) };
  OverrideCamera(arguments, scene.camera);
  scene.cuts.bodyOnly = arguments.bodyOnly || scene.cuts.bodyOnly;
  scene.cuts.faceDepthMm = arguments.faceDepthMm.value_or(scene.cuts.faceDepthMm);
  if (scene.cuts.bodyOnly && !HasBodyMask(loaded.modality))
  {
    throw std::runtime_error(
      "The table can be removed from CT only, whose values have a unit; found " +
      (loaded.modality.empty() ? "a volume of unknown modality" : loaded.modality));
  }
  OverrideSampling(arguments, scene.render);
  scene.size = arguments.size.value_or(scene.size);
  scene.background = arguments.background.value_or(scene.background);
  return { scene, loaded };
}

std::pair<Scene, LoadedVolume> LoadScene(const SceneArguments& arguments)
{
  return LoadScene(arguments, arguments.volume.input);
}

}
