#include "BenchScenes.h"

#include "BenchMethods.h"
#include "CommandLine/Progress.h"
#include "CommandLine/SceneArguments.h"
#include "CommandLine/UsageError.h"
#include "CommandLine/VolumeArguments.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace varimarch
{

namespace
{

/// The interesting values of a volume, in units of the data.
struct SpeedVolume
{
  std::string name;
  std::string file;     ///< path in the folder of volumes
  double lowest;        ///< lowest visible value, above air and noise
  double highest;       ///< highest visible value
  double peak;          ///< value of a surface
  double peakHalfWidth; ///< half the width of the peak, > 0
};

const std::vector<SpeedVolume>& SpeedVolumes()
{
  static const std::vector<SpeedVolume> volumes = {
    { "vismale", "vismale/vismale_128x256x256_uint8.mhd", 40.0, 220.0, 70.0, 10.0 },
    { "bonsai", "bonsai/bonsai_256x256x256_uint8.mhd", 35.0, 200.0, 50.0, 6.0 },
    { "tooth", "tooth/tooth_103x94x161_uint8.mhd", 50.0, 240.0, 170.0, 10.0 },
    { "engine", "engine/engine_256x256x128_uint8.mhd", 60.0, 240.0, 180.0, 10.0 },
    { "aneurism", "aneurism/aneurism_256x256x256_uint8.mhd", 40.0, 240.0, 90.0, 15.0 },
    { "abdomen", "ct_abdomen_pancreas/dicom", 80.0, 900.0, -300.0, 60.0 },
    { "skull", "ct_skull_phantom/dicom", 300.0, 2500.0, 600.0, 80.0 },
    { "mr-head", "mr_head_studyforrest/mr_head_studyforrest_274x384x384_int16.mha", 40.0, 220.0,
      20.0, 8.0 },
  };
  return volumes;
}

Look LookOf(const SpeedVolume& seen, vtkImageData* image)
{
  Look look;
  look.colors = { { seen.lowest, { 0.55, 0.25, 0.15 }, {} },
    { 0.5 * (seen.lowest + seen.highest), { 0.90, 0.75, 0.55 }, {} },
    { seen.highest, { 1.0, 1.0, 0.95 }, {} } };
  look.opacityUnitDistanceMm = VoxelMm(image);
  return look;
}

// A translucent look with a long ramp of opacity. The unit distance of opacity is the smallest
// voxel spacing.
Look SoftLook(const SpeedVolume& seen, vtkImageData* image)
{
  Look look = LookOf(seen, image);
  look.opacities = { { seen.lowest, 0.0, {} }, { seen.highest, 0.06, {} } };
  return look;
}

// A look that is opaque within a few voxels.
Look DenseLook(const SpeedVolume& seen, vtkImageData* image)
{
  Look look = LookOf(seen, image);
  const double opaque = seen.lowest + 0.25 * (seen.highest - seen.lowest);
  look.opacities = { { seen.lowest, 0.0, {} }, { opaque, 0.7, {} } };
  return look;
}

// A look with only the values of one surface, in false colours.
Look ThinPeakLook(const SpeedVolume& seen, vtkImageData* image)
{
  Look look = LookOf(seen, image);
  const double left = seen.peak - seen.peakHalfWidth;
  const double right = seen.peak + seen.peakHalfWidth;
  look.colors = { { left, { 0.2, 0.5, 0.9 }, {} }, { right, { 1.0, 0.8, 0.3 }, {} } };
  look.opacities = { { left, 0.0, {} }, { seen.peak, 0.25, {} }, { right, 0.0, {} } };
  return look;
}

struct SpeedLook
{
  std::string name;
  Look (*make)(const SpeedVolume& seen, vtkImageData* image);
};

const std::vector<SpeedLook>& SpeedLooks()
{
  static const std::vector<SpeedLook> looks = { { "soft", SoftLook }, { "dense", DenseLook },
    { "thin-peak", ThinPeakLook } };
  return looks;
}

std::string SceneName(const SpeedVolume& seen, const SpeedLook& look)
{
  return seen.name + "-" + look.name;
}

std::vector<SpeedLook> ChosenLooks(
  const SpeedVolume& seen, const std::vector<std::string>& prefixes)
{
  std::vector<SpeedLook> chosen;
  for (const SpeedLook& look : SpeedLooks())
  {
    const std::string name = SceneName(seen, look);
    const auto isPrefix = [&](const std::string& prefix)
    { return name.compare(0, prefix.size(), prefix) == 0; };
    if (prefixes.empty() || std::any_of(prefixes.begin(), prefixes.end(), isPrefix))
    {
      chosen.push_back(look);
    }
  }
  return chosen;
}

LoadedScene SceneOf(const SpeedVolume& seen, const SpeedLook& look, const LoadedVolume& volume)
{
  LoadedScene loaded = { SceneName(seen, look), {}, volume };
  loaded.scene.look = look.make(seen, volume.image);
  loaded.scene.look.name = look.name;
  // The view is oblique, so that no ray runs along a row of voxels.
  loaded.scene.camera.azimuthDegrees = 30.0;
  loaded.scene.camera.elevationDegrees = 20.0;
  return loaded;
}

// The scenes made from a folder of volumes.
std::vector<LoadedScene> ScenesOfFolder(const std::string& folder,
  const std::vector<std::string>& prefixes, std::vector<std::string>& missing)
{
  std::vector<LoadedScene> scenes;
  for (const SpeedVolume& seen : SpeedVolumes())
  {
    const std::vector<SpeedLook> looks = ChosenLooks(seen, prefixes);
    const std::string path = folder + "/" + seen.file;
    if (looks.empty())
    {
      continue;
    }
    if (!std::filesystem::exists(path))
    {
      missing.push_back(seen.file);
      continue;
    }
    const LoadedVolume volume = LoadVolumeReporting(FileSource{ path, std::nullopt });
    for (const SpeedLook& look : looks)
    {
      scenes.push_back(SceneOf(seen, look, volume));
    }
  }
  if (scenes.empty())
  {
    throw std::runtime_error(folder + ": expected volumes such as " + SpeedVolumes()[0].file +
      ", and scenes such as vismale-soft, found none");
  }
  return scenes;
}

std::vector<LoadedScene> LoadScenes(
  const BenchSceneOptions& options, std::vector<std::string>& missing)
{
  std::vector<LoadedScene> scenes;
  if (!options.volumes.empty())
  {
    scenes = ScenesOfFolder(options.volumes, options.only, missing);
  }
  for (const std::string& input : options.inputs)
  {
    const auto [scene, volume] = LoadScene(SceneArguments(), input);
    scenes.push_back({ std::filesystem::path(input).stem().string(), scene, volume });
  }
  if (scenes.empty())
  {
    throw UsageError("SCENES or --volumes is required");
  }
  return scenes;
}

}

void AddBenchSceneOptions(CLI::App& command, BenchSceneOptions& options)
{
  command.add_option("SCENES", options.inputs,
    "Scene files (.json), volume files, DICOM folders, or procedural:NAME[:XxYxZ]");
  command
    .add_option("--volumes", options.volumes,
      "A folder of well-known volumes, each drawn soft, dense and as a thin peak")
    ->check(CLI::ExistingDirectory.description(""))
    ->type_name("FOLDER");
  command
    .add_option(
      "--only", options.only, "Draw only scenes of --volumes whose names start with one of these")
    ->delimiter(',')
    ->type_name("NAMES");
}

void MeasureSceneByScene(const BenchSceneOptions& options, BenchResults& results,
  const std::function<void(const LoadedScene&, const OnStep&)>& measure)
{
  std::vector<std::string> missing;
  const std::vector<LoadedScene> scenes = LoadScenes(options, missing);
  results.json["missing"] = missing;
  for (std::size_t i = 0; i < scenes.size(); ++i)
  {
    Progress progress("Measuring " + scenes[i].name);
    measure(scenes[i], [&](const std::string& step) { progress.SetActivity(step); });
    results.Write(std::to_string(i + 1) + " of " + std::to_string(scenes.size()) + " scenes");
  }
}

}
