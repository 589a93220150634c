#include "Scene/SceneFile.h"

#include "Scene/CameraJson.h"
#include "Scene/CutsJson.h"
#include "Scene/KeyImagesJson.h"
#include "Scene/LabelsJson.h"
#include "Scene/LightsJson.h"
#include "Scene/LookJson.h"
#include "Scene/MeasuresJson.h"
#include "Scene/OverlaysJson.h"
#include "Scene/Presets.h"
#include "Scene/RenderJson.h"
#include "Scene/SceneLights.h"
#include "Scene/SceneVolumes.h"
#include "Scene/SlicesJson.h"
#include "Scene/VolumeJson.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <limits>

namespace varimarch
{

namespace
{

// All relevant OpenGL versions guarantee 2D textures of at least this size.
constexpr int LargestPictureSide = 16384;

// Editors find the schema through "$schema"; it is ignored here.
std::vector<std::string> KeysBesideVolume()
{
  return { "$schema", "look", "lights", "shadows", "scattering", "occlusion", "camera", "cuts",
    "slices", "measures", "keyImages", "distances", "angles", "boxes", "labels", "overlays",
    "render", "size", "background" };
}

void ReadAllButVolume(const JsonCursor& json, Scene& scene)
{
  // The preset's settings come first, so that the scene's own keys override them.
  TakePreset(PresetFromJson(json.At("look")), scene);
  TakeLighting(LightingFromJson(json), scene);
  if (const auto camera = json.Find("camera"))
  {
    scene.camera = CameraFromJson(*camera);
  }
  if (const auto cuts = json.Find("cuts"))
  {
    scene.cuts = CutsFromJson(*cuts);
  }
  if (const auto slices = json.Find("slices"))
  {
    scene.slices = SlicesFromJson(*slices);
  }
  scene.measures = MeasuresFromJson(json);
  scene.keyImages = KeyImagesFromJson(json);
  if (const auto labels = json.Find("labels"))
  {
    scene.labels = LabelsFromJson(*labels);
  }
  if (const auto overlays = json.Find("overlays"))
  {
    scene.overlays = OverlaysFromJson(*overlays);
  }
  if (const auto render = json.Find("render"))
  {
    ReadRender(*render, scene.render);
  }
  if (const auto size = json.Find("size"))
  {
    scene.size = size->Integers<2>(1, LargestPictureSide);
  }
  if (const auto background = json.Find("background"))
  {
    scene.background = background->Numbers<3>({ 0.0, 1.0 });
  }
}

Scene SceneFromJson(const JsonCursor& json)
{
  std::vector<std::string> keys = KeysBesideVolume();
  keys.insert(keys.begin() + 1, "volume");
  json.RequireObject(keys);
  Scene scene;
  scene.volume = VolumeFromJson(json.At("volume"));
  ReadAllButVolume(json, scene);
  return scene;
}

}

std::string SceneText(const Scene& scene)
{
  nlohmann::ordered_json json;
  json["volume"] = JsonFromVolume(scene.volume);
  json["look"] = JsonFromLook(scene.look);
  AddLighting(LightingOf(scene), json);
  json["camera"] = JsonFromCamera(scene.camera);
  json["cuts"] = JsonFromCuts(scene.cuts);
  json["slices"] = JsonFromSlices(scene.slices);
  json["measures"] = JsonFromMeasures(scene.measures);
  if (!scene.keyImages.empty())
  {
    json["keyImages"] = JsonFromKeyImages(scene.keyImages);
  }
  if (scene.labels)
  {
    json["labels"] = JsonFromLabels(*scene.labels);
  }
  if (!scene.overlays.empty())
  {
    json["overlays"] = JsonFromOverlays(scene.overlays);
  }
  json["render"] = JsonFromRender(scene.render);
  json["size"] = scene.size;
  json["background"] = scene.background;
  return TextFromJson(json);
}

std::string LookText(const Look& look)
{
  return TextFromJson(JsonFromLook(look));
}

std::string PresetText(const Preset& preset)
{
  return TextFromJson(JsonFromPreset(preset));
}

Scene SceneFromText(const std::string& text, const std::string& file)
{
  return SceneFromJson(JsonCursor(ParseJson(text, file), file));
}

Scene SceneWithoutVolumeFromText(const std::string& text, const std::string& file)
{
  const nlohmann::json parsed = ParseJson(text, file);
  const JsonCursor json(parsed, file);
  json.RequireObject(KeysBesideVolume());
  Scene scene;
  ReadAllButVolume(json, scene);
  return scene;
}

Preset PresetFromText(const std::string& text, const std::string& file)
{
  return PresetFromJson(JsonCursor(ParseJson(text, file), file));
}

bool IsSceneFile(const std::string& path)
{
  if (std::filesystem::path(path).extension() == ".json")
  {
    return true;
  }
  // Opening a pipe would wait for its writer.
  std::error_code unknown;
  char first = 0;
  return std::filesystem::is_regular_file(path, unknown) && std::ifstream(path) >> first &&
    first == '{';
}

Scene ReadScene(const std::string& path)
{
  Scene scene = SceneFromJson(JsonCursor(ReadJson(path), path));
  const auto startAtScene = [folder = std::filesystem::path(path).parent_path()](std::string& file)
  {
    // An absolute path is unchanged by operator/.
    file = (folder / file).string();
  };
  const auto startVolumeAtScene = [&](VolumeSource& volume)
  {
    if (auto* const file = std::get_if<FileSource>(&volume))
    {
      startAtScene(file->path);
    }
  };
  startVolumeAtScene(scene.volume);
  for (OverlaidVolume& overlay : scene.overlays)
  {
    startVolumeAtScene(overlay.source);
  }
  for (int volume = 0; volume < VolumeCount(scene); ++volume)
  {
    if (auto& labels = SceneLabelsOf(scene, volume))
    {
      startAtScene(labels->path);
    }
  }
  return scene;
}

}
