#ifndef Varimarch_CommandLine_Options_h
#define Varimarch_CommandLine_Options_h

#include "Scene/Scene.h"
#include "Scene/VolumeLoading.h"
#include "VolumeOptions.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// What render, compare and bench have in common: everything a scene file can say, each overriding
/// it.
class SceneOptions
{
public:
  /// One input and all options.
  void AddTo(CLI::App& command);

  /// For a command with inputs of its own, which chooses the sampling itself.
  void AddLookAndPictureTo(CLI::App& command);

  /// The scene of the input, with what the options override, and its volume.
  /// @throws std::runtime_error when a file cannot be read
  std::pair<Scene, LoadedVolume> Load() const { return this->Load(this->volume.Input()); }

  /// The same of any input.
  std::pair<Scene, LoadedVolume> Load(const std::string& input) const;

private:
  void AddLookOptions(CLI::App& command);
  void AddPictureOptions(CLI::App& command);
  void AddSamplingOptions(CLI::App& command);
  std::optional<Preset> ChosenPreset(vtkImageData* image) const;
  void Override(Scene& scene) const;

  VolumeOptions volume;
  std::string preset;
  std::string transferFunction;
  std::optional<bool> shade;
  std::string blend;
  std::string size;
  std::string view;
  std::optional<double> azimuth;
  std::optional<double> elevation;
  std::optional<double> zoom;
  bool parallel = false;
  std::vector<double> background;
  std::optional<double> sampleDistance;
  std::string acceleration;
  std::string integration;
  std::optional<double> errorTolerance;
  std::optional<double> tolerance;
};

/// Adds `--json FILE`.
void AddJsonOption(CLI::App& command, std::string& path);

/// Reads a volume with a line about it on stderr when that takes long, and its warnings.
LoadedVolume LoadVolumeReporting(const VolumeSource& source);

/// Of the benches: the folder that the report goes to, and how often each is measured.
void AddOutputOption(CLI::App& command, std::string& folder);
void AddRoundsOption(CLI::App& command, int& rounds);

}

#endif
