#ifndef Varimarch_CommandLine_SceneArguments_h
#define Varimarch_CommandLine_SceneArguments_h

#include "Scene/Scene.h"
#include "Scene/VolumeLoading.h"
#include "VolumeArguments.h"

#include <array>
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
  std::string preset;           ///< name of a built-in preset; empty: chosen for the volume
  std::string transferFunction; ///< file with looks; empty: the preset's look
  std::string lookName;         ///< name of a look in that file; empty: its only look
  std::string regions;          ///< file of regions; empty: those of the look
  std::optional<bool> shade;
  std::optional<Blend> blend;
  std::optional<double> dampingGradient; ///< as in Look
  std::vector<SceneLight> lights;        ///< empty: those of the scene
  std::optional<double> softnessDegrees; ///< softness of all of these lights, [0, 60]
  bool presetLight = false;              ///< the scene takes the light that suits its preset
  std::optional<double> shadows;         ///< their strength, [0, 1]
  std::optional<double> scattering;      ///< blending of scattered light, [0, 2]
  std::optional<double> anisotropy;      ///< [-0.99, 0.99]
  std::optional<double> scatteringReach; ///< [0, 1]
  std::optional<double> occlusion;       ///< strength of ambient occlusion, [0, 1]
  std::optional<double> occlusionReachMm;
  std::optional<std::array<int, 2>> size; ///< size of the image [pixels]
  std::optional<View> view;
  std::optional<double> azimuthDegrees;
  std::optional<double> elevationDegrees;
  std::optional<double> zoom;
  bool parallel = false;
  std::optional<std::array<double, 2>> clippingRangeMm;
  bool bodyOnly = false;
  std::optional<double> faceDepthMm;               ///< as in SceneCuts
  std::optional<std::array<double, 3>> background; ///< background as RGB, [0, 1]
  std::optional<double> sampleDistanceMm;          ///< sample distance, > 0
  std::optional<Acceleration> acceleration;
  std::optional<Integration> integration;
  std::optional<double> errorTolerance;     ///< error tolerance, [0, 1]
  std::optional<double> variationTolerance; ///< tolerance of a field of values [units of the data]
  std::optional<double> sampleDistanceVoxels; ///< sample distance in smallest spacings, > 0
  std::optional<int> mostSteps;               ///< sample distances after which a ray ends
  std::optional<double> firstDistanceMm;      ///< distance from the eye at which rays begin
  std::optional<double> earlyTerminationTransmittance; ///< [0, 1)
  std::optional<Interpolation> interpolation;
  std::optional<VolumeLevel> level;
  bool jitter = false;
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
