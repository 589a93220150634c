#include "PublishedScenes.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <stdexcept>

namespace varimarch
{

namespace
{

constexpr const char* VisMale = "vismale/vismale_128x256x256_uint8.mhd";

BenchMethod Method(const std::string& name, MapperKind kind)
{
  return { name, name, kind, {} };
}

RenderOptions With(Acceleration acceleration, Integration integration, double earlyTermination)
{
  RenderOptions options;
  options.acceleration = acceleration;
  options.integration = integration;
  options.earlyTerminationTransmittance = earlyTermination;
  return options;
}

double LongestEdgeMm(vtkImageData* image)
{
  const double* bounds = image->GetBounds();
  return std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
}

// The paper does not give its transfer function. We use a grey ramp that is clear below a threshold
// and otherwise transparent enough that rays reach deep into the volume, as in the paper's loop,
// which has no early termination. The unit distance of opacity is a hundredth of the volume.
Look BanqueroLook(vtkImageData* image)
{
  Look look;
  look.name = "grey ramp";
  look.domain = Domain::Relative;
  look.colors = { { 0.1, { 0.0, 0.0, 0.0 }, {} }, { 1.0, { 1.0, 1.0, 1.0 }, {} } };
  look.opacities = { { 0.15, 0.0, {} }, { 1.0, 0.3, {} } };
  look.opacityUnitDistanceMm = LongestEdgeMm(image) / 100.0;
  look.shading.enabled = false;
  return look;
}

// Sample distances at which the volume's longest edge has as many samples as the paper's loop has
// steps.
std::vector<BenchRun> BanqueroRuns(vtkImageData* image)
{
  constexpr double PublishedVariation255 = 4.0; // figure 10, free of artifacts
  const auto run =
    [&](const std::string& name, Acceleration acceleration, Integration rule, double termination)
  {
    BenchRun swept = { Method(name, MapperKind::VarimarchShaders), {} };
    RenderOptions options = With(acceleration, rule, termination);
    options.variationTolerance = Variation(image, PublishedVariation255);
    for (const int steps : PublishedSteps)
    {
      const double voxels = LongestEdgeMm(image) / steps / VoxelMm(image);
      swept.settings.push_back(AtDistance(image, voxels, options));
    }
    return swept;
  };
  return { run("plain", Acceleration::Off, Integration::PublishedSum, 0.0),
    run("field", Acceleration::VariationField, Integration::PublishedSum, 0.0),
    run("ours", Acceleration::OpticalField, Integration::Midpoint,
      RenderOptions().earlyTerminationTransmittance) };
}

// Values up to 40 are clear; values from 41 share one opacity. The paper does not give its unit
// distance; we use one voxel.
Look VoltLook(vtkImageData* image, int alpha255, bool shaded)
{
  Look look;
  look.name = "Volt, alpha " + std::to_string(alpha255);
  look.colors = { { 41.0, { 0.75, 0.50, 0.40 }, {} }, { 255.0, { 1.0, 0.95, 0.85 }, {} } };
  look.opacities = { { 40.0, 0.0, {} }, { 41.0, alpha255 / 255.0, {} } };
  look.opacityUnitDistanceMm = VoxelMm(image);
  look.shading.enabled = shaded;
  return look;
}

std::vector<BenchRun> VoltRuns(vtkImageData* image)
{
  constexpr double Voxels = 0.49;
  constexpr double Saturated = 0.05; // a saturation of 95 %
  const auto run = [&](const std::string& name, MapperKind kind, Acceleration acceleration)
  {
    return BenchRun{ Method(name, kind),
      { AtDistance(image, Voxels, With(acceleration, Integration::Midpoint, Saturated)) } };
  };
  return { run("ours", MapperKind::Varimarch, Acceleration::OpticalField),
    run("off", MapperKind::Varimarch, Acceleration::Off),
    run("vtk-gpu", MapperKind::VtkGpu, Acceleration::Off) };
}

// Measures all runs of one scene, however long they take.
WorkPrecision Measured(const std::string& name, const Look& look, const LoadedVolume& volume,
  const std::vector<BenchRun>& runs, const PublishedOptions& options, const OnStep& onStep)
{
  Scene scene;
  scene.look = look;
  scene.size = { options.side, options.side };
  return MeasureRuns(
    name, scene, volume, runs, { options.rounds, std::numeric_limits<double>::infinity() }, onStep);
}

void AddVolt(const PublishedOptions& options, const OnStep& onStep, const OnPublished& onMeasured,
  PublishedMeasurements& result)
{
  const LoadedVolume volume =
    LoadVolume(FileSource{ options.folder + "/" + VisMale, std::nullopt });
  for (const int alpha255 : { 15, 63, 255 })
  {
    for (const bool shaded : { false, true })
    {
      const Look look = VoltLook(volume.image, alpha255, shaded);
      result.volt.push_back({ alpha255, shaded,
        Measured(look.name, look, volume, VoltRuns(volume.image), options, onStep) });
      onMeasured(result);
    }
  }
}

}

const std::vector<PublishedVolume>& PublishedVolumes()
{
  static const std::vector<PublishedVolume> volumes = {
    { "SKULL", "ct_skull_phantom/dicom", "another skull, of plastic, 512 x 512 x 140",
      { 60.0, 59.8, 26.5, 11.1 }, 48.0, 59.0 },
    { "MRI HEAD", "mr_head_studyforrest/mr_head_studyforrest_274x384x384_int16.mha",
      "another head, 274 x 384 x 384", { 60.0, 54.8, 23.2, 10.3 }, 50.0, 60.0 },
    { "VIS MALE", VisMale, "128 x 256 x 256; theirs 128^3 at 80 steps and in table 2, else 256^3",
      { 0.0, 0.0, 60.0, 32.1 }, 45.0, 60.0 },
    { "BONZAI", "bonsai/bonsai_256x256x256_uint8.mhd", "the same", {}, 30.0, 55.0 },
    { "TOOTH", "tooth/tooth_103x94x161_uint8.mhd", "103 x 94 x 161; theirs 64^3", {}, 60.0, 60.0 },
  };
  return volumes;
}

PublishedMeasurements MeasurePublished(
  const PublishedOptions& options, const OnStep& onStep, const OnPublished& onMeasured)
{
  PublishedMeasurements result;
  for (const PublishedVolume& published : PublishedVolumes())
  {
    const std::string path = options.folder + "/" + published.file;
    if (!std::filesystem::exists(path))
    {
      result.missing.push_back(published.file);
      continue;
    }
    onStep("Reading " + path);
    const LoadedVolume volume = LoadVolume(FileSource{ path, std::nullopt });
    result.volumes.push_back({ published,
      Measured(published.name, BanqueroLook(volume.image), volume, BanqueroRuns(volume.image),
        options, onStep) });
    onMeasured(result);
  }
  if (result.volumes.empty())
  {
    throw std::runtime_error(
      options.folder + ": expected volumes such as " + VisMale + ", found none");
  }
  if (std::filesystem::exists(options.folder + "/" + VisMale))
  {
    AddVolt(options, onStep, onMeasured, result);
  }
  return result;
}

}
