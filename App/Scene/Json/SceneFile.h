#ifndef Varimarch_Scene_SceneFile_h
#define Varimarch_Scene_SceneFile_h

#include "Scene/Model/Scene.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace varimarch
{

class JsonCursor;

/// Scenes, looks and presets as JSON. Documentation/SceneFormat.md describes the format, and
/// Data/Scenes/scene.schema.json defines it for editors.
///
/// Every reading function throws std::runtime_error with one sentence that names the file, the path
/// of the key, the expected value and the found one.

/// True for JSON, which is recognised by the extension .json or by its first character.
bool IsSceneFile(const std::string& path);

/// Reads a scene. Relative paths of volumes and labels start at the scene file's folder.
Scene ReadScene(const std::string& path);

/// Optional keys are always written, so that the text holds the whole scene.
std::string SceneText(const Scene& scene);
std::string LookText(const Look& look);
std::string PresetText(const Preset& preset);

/// A scene with some settings changed. Its volume stays.
/// @param patch  a JSON merge patch (RFC 7396) for the text of the scene
/// @param name   of the patch, for errors
Scene WithSettings(
  const Scene& scene, const nlohmann::ordered_json& patch, const std::string& name);

/// Parse a text instead of a file; `file` is its name in errors.
Scene SceneFromText(const std::string& text, const std::string& file);
/// The same without the key "volume", for a caller that has the volume already.
Scene SceneWithoutVolumeFromText(const std::string& text, const std::string& file);
Preset PresetFromText(const std::string& text, const std::string& file);
/// A list of segments, each value at most once.
std::vector<Segment> SegmentsFromText(const std::string& text, const std::string& file);

/// Reads a file that holds an array of regions.
std::vector<LookRegion> ReadRegions(const std::string& path);

/// Reads a preset from a JSON object, or the built-in preset that a JSON string names.
Preset PresetFromJson(const JsonCursor& json);
nlohmann::ordered_json JsonFromPreset(const Preset& preset);

}

#endif
