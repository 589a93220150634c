#include "Scene/Json/SceneFile.h"

#include "Scene/Json/SceneFields.h"
#include "Scene/Model/Scene.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace varimarch
{

namespace
{

Scene SceneFromJson(const JsonCursor& json)
{
  Scene scene;
  SceneFields().Read(json, scene);
  return scene;
}

}

Preset PresetFromJson(const JsonCursor& json)
{
  Preset preset;
  PresetForm().read(json, preset);
  return preset;
}

nlohmann::ordered_json JsonFromPreset(const Preset& preset)
{
  return PresetFields().Write(preset);
}

std::string SceneText(const Scene& scene)
{
  return TextFromJson(SceneFields().Write(scene));
}

Scene WithSettings(const Scene& scene, const nlohmann::ordered_json& patch, const std::string& name)
{
  nlohmann::ordered_json written = FieldsBesideVolume().Write(scene);
  written.merge_patch(patch);
  const nlohmann::json json = written;
  Scene changed;
  changed.volume = scene.volume;
  FieldsBesideVolume().Read(JsonCursor(json, name), changed);
  return changed;
}

std::string LookText(const Look& look)
{
  return TextFromJson(LookFields().Write(look));
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
  Scene scene;
  FieldsBesideVolume().Read(JsonCursor(parsed, file), scene);
  return scene;
}

Preset PresetFromText(const std::string& text, const std::string& file)
{
  return PresetFromJson(JsonCursor(ParseJson(text, file), file));
}

std::vector<Segment> SegmentsFromText(const std::string& text, const std::string& file)
{
  const nlohmann::json parsed = ParseJson(text, file);
  std::vector<Segment> segments;
  SegmentsForm().read(JsonCursor(parsed, file), segments);
  return segments;
}

std::vector<LookRegion> ReadRegions(const std::string& path)
{
  const nlohmann::json json = ReadJson(path);
  std::vector<LookRegion> regions;
  RegionsForm().read(JsonCursor(json, path), regions);
  return regions;
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
