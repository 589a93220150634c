#include "SceneArguments.h"

#include "Scene/ImageStatistics.h"
#include "Scene/LookFiles.h"
#include "Scene/PresetSuggestion.h"
#include "Scene/Presets.h"
#include "Scene/SceneFile.h"
#include "UsageError.h"

namespace varimarch
{

namespace
{

bool IsSceneFile(const std::string& input)
{
  const std::string extension = ".json";
  return input.size() > extension.size() &&
    input.compare(input.size() - extension.size(), extension.size(), extension) == 0;
}

std::optional<Preset> ChosenPreset(const SceneArguments& arguments, vtkImageData* image)
{
  if (!arguments.transferFunction.empty())
  {
    return ReadLookFile(arguments.transferFunction, ContextOf(image));
  }
  if (!arguments.preset.empty())
  {
    return BuiltInPreset(arguments.preset);
  }
  return std::nullopt;
}

void OverrideLook(const SceneArguments& arguments, Look& look)
{
  look.shading.enabled = arguments.shade.value_or(look.shading.enabled);
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
}

void OverrideSampling(const SceneArguments& arguments, RenderOptions& render)
{
  if (arguments.sampleDistanceMm)
  {
    render.sampleDistanceMm = arguments.sampleDistanceMm;
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
}

}

std::pair<Scene, LoadedVolume> LoadScene(const SceneArguments& arguments, const std::string& input)
{
  const bool isScene = IsSceneFile(input);
  if (isScene)
  {
    RejectFileArguments(arguments.volume, "scene file");
  }
  Scene scene = isScene ? ReadScene(input) : Scene();
  scene.volume =
    isScene ? Override(arguments.volume, scene.volume) : SourceOf(arguments.volume, input);
  LoadedVolume loaded = LoadVolumeReporting(scene.volume);
  if (const std::optional<Preset> chosen = ChosenPreset(arguments, loaded.image))
  {
    TakePreset(*chosen, scene);
  }
  else if (!isScene)
  {
    TakePreset(BuiltInPreset(SuggestedPreset(loaded, ImageStatistics(loaded.image)).name), scene);
  }
  OverrideLook(arguments, scene.look);
  OverrideCamera(arguments, scene.camera);
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
