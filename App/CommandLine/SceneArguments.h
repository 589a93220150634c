#ifndef Varimarch_CommandLine_SceneArguments_h
#define Varimarch_CommandLine_SceneArguments_h

#include "Scene/Model/Scene.h"
#include "Scene/Volumes/VolumeLoading.h"
#include "VolumeArguments.h"

#include <nlohmann/json.hpp>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace varimarch
{

/// The description of a scene on the command line: a volume or scene file, and settings that
/// override those of the file.
struct SceneArguments
{
  VolumeArguments volume;
  std::string preset;             ///< name of a built-in preset; empty: chosen for the volume
  std::string transferFunction;   ///< file with looks; empty: the preset's look
  std::string lookName;           ///< name of a look in that file; empty: its only look
  std::string regions;            ///< file of regions; empty: those of the look
  std::vector<SceneLight> lights; ///< empty: those of the scene
  std::optional<double> softnessDegrees; ///< softness of all of these lights, [0, 60]
  bool presetLight = false;              ///< the scene takes the light that suits its preset
  /// Values of the scene's keys, by JSON pointers such as "/camera/zoom"; null: those of the scene.
  std::map<std::string, nlohmann::ordered_json> settings;
};

/// Loads the scene that an input and the arguments describe, with its volume.
/// @param input  a scene file or a volume
/// @param mayBePreview  true to get a preview, see LoadVolume, for a coarse image without labels
/// @throws UsageError when the arguments do not fit the input
/// @throws std::runtime_error when a file cannot be read
std::pair<Scene, LoadedVolume> LoadScene(
  const SceneArguments& arguments, const std::string& input, bool mayBePreview = false);

/// Loads the scene of the arguments' own input.
std::pair<Scene, LoadedVolume> LoadScene(const SceneArguments& arguments);

}

#endif
