#ifndef Varimarch_Scene_SceneFile_h
#define Varimarch_Scene_SceneFile_h

#include "Scene/Scene.h"

#include <string>

namespace varimarch
{

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

/// Parse a text instead of a file; `file` is its name in errors.
Scene SceneFromText(const std::string& text, const std::string& file);
/// The same without the key "volume", for a caller that has the volume already.
Scene SceneWithoutVolumeFromText(const std::string& text, const std::string& file);
Preset PresetFromText(const std::string& text, const std::string& file);

}

#endif
