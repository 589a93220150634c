#include "SceneArguments.h"

#include "Scene/Json/SceneFile.h"
#include "Scene/Json/SceneNames.h"
#include "Scene/Looks/LookFiles.h"
#include "Scene/Looks/Presets.h"
#include "Scene/Looks/VolumeProperty.h"
#include "Scene/Model/SceneLights.h"
#include "Scene/Segments/BodyMask.h"
#include "Scene/Segments/LabelMap.h"
#include "Scene/Volumes/ImageStatistics.h"
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

// The settings as a merge patch for a scene file.
nlohmann::ordered_json PatchOf(const SceneArguments& arguments)
{
  nlohmann::ordered_json patch = nlohmann::ordered_json::object();
  for (const auto& [pointer, value] : arguments.settings)
  {
    if (!value.is_null())
    {
      patch[nlohmann::ordered_json::json_pointer(pointer)] = value;
    }
  }
  if (patch.contains("render") && patch["render"].contains("sampleDistance"))
  {
    patch["render"]["sampleDistanceVoxels"] = "auto";
  }
  return patch;
}

std::optional<nlohmann::ordered_json> ValueAt(
  const nlohmann::ordered_json& patch, const std::string& pointer)
{
  const nlohmann::ordered_json::json_pointer place(pointer);
  return patch.contains(place) ? std::optional(patch[place]) : std::nullopt;
}

// Checks settings together, with messages that name their options.
void CheckSettings(const nlohmann::ordered_json& patch, const Look& look)
{
  if (ValueAt(patch, "/look/blend") == NameOf(BlendNames(), Blend::Isosurface) &&
    look.isosurfaces.empty())
  {
    throw UsageError("--blend: isosurface needs a look that has isosurfaces");
  }
  const auto range = ValueAt(patch, "/camera/clippingRange");
  if (range && !((*range)[0] < (*range)[1]))
  {
    throw UsageError("--clipping-range: expected the nearer distance first");
  }
}

void OverrideLights(const SceneArguments& arguments, std::vector<SceneLight>& lights)
{
  lights = arguments.lights.empty() ? lights : arguments.lights;
  for (SceneLight& light : lights)
  {
    const double softness = arguments.softnessDegrees.value_or(light.softnessDegrees);
    light.softnessDegrees = light.kind == LightKind::Head ? 0.0 : softness;
  }
}

void RequireBody(const LoadedVolume& loaded)
{
  if (!HasBodyMask(loaded.modality))
  {
    throw std::runtime_error(
      "The table can be removed from CT only, whose values have a unit; found " +
      (loaded.modality.empty() ? "a volume of unknown modality" : loaded.modality));
  }
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
  const nlohmann::ordered_json patch = PatchOf(arguments);
  const bool isCoarse =
    ValueAt(patch, "/render/detail").value_or(NameOf(LevelNames(), scene.render.level)) ==
    NameOf(LevelNames(), VolumeLevel::Coarse);
  // Labels lie on the voxels of the volume itself.
  LoadedVolume loaded =
    LoadVolumeReporting(scene.volume, mayBePreview && isCoarse && !scene.labels);
  OverridePreset(arguments, ChosenPreset(arguments, loaded, isScene, scene), scene);
  if (!arguments.regions.empty())
  {
    scene.look.regions = ReadRegions(arguments.regions);
  }
  CheckSettings(patch, scene.look);
  scene = WithSettings(scene, patch, "the options");
  OverrideLights(arguments, scene.lights);
  if (scene.cuts.bodyOnly)
  {
    RequireBody(loaded);
  }
  return { scene, loaded };
}

std::pair<Scene, LoadedVolume> LoadScene(const SceneArguments& arguments)
{
  return LoadScene(arguments, arguments.volume.input);
}

}
