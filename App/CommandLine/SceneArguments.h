#ifndef Varimarch_CommandLine_SceneArguments_h
#define Varimarch_CommandLine_SceneArguments_h

#include "Scene/Scene.h"
#include "Scene/VolumeLoading.h"
#include "VolumeArguments.h"

#include <array>
#include <optional>
#include <string>
#include <utility>

namespace varimarch
{

/// A scene, as the command line describes it: a volume or scene file, and everything that a scene
/// file can say. What is given here overrides the file.
struct SceneArguments
{
  VolumeArguments volume;
  std::string preset;           ///< name of a built-in preset; empty: chosen by the volume
  std::string transferFunction; ///< file with a look; empty: the preset's look
  std::optional<bool> shade;
  std::optional<Blend> blend;
  std::optional<std::array<int, 2>> size; ///< [pixels]
  std::optional<View> view;
  std::optional<double> azimuthDegrees;
  std::optional<double> elevationDegrees;
  std::optional<double> zoom;
  bool parallel = false;
  std::optional<std::array<double, 3>> background; ///< RGB, [0, 1]
  std::optional<double> sampleDistanceMm;          ///< > 0
  std::optional<Acceleration> acceleration;
  std::optional<Integration> integration;
  std::optional<double> errorTolerance;     ///< [0, 1]
  std::optional<double> variationTolerance; ///< [units of the data], >= 0
};

/// The scene that an input and the arguments describe, with its volume in memory.
/// @param input  a scene file or a volume
/// @throws UsageError when the arguments do not fit the input
/// @throws std::runtime_error when a file cannot be read
std::pair<Scene, LoadedVolume> LoadScene(const SceneArguments& arguments, const std::string& input);

/// The scene of the arguments' own input.
std::pair<Scene, LoadedVolume> LoadScene(const SceneArguments& arguments);

}

#endif
