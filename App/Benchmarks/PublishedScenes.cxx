#include "PublishedScenes.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <stdexcept>

namespace varimarch
{

namespace
{

BenchMethod Method(const std::string& name, MapperKind kind)
{
  return { name, name, kind, {} };
}

double LongestEdgeMm(vtkImageData* image)
{
  const double* bounds = image->GetBounds();
  return std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
}

// The loop with each number of steps of table 1, which are one voxel long.
BenchRun StepsRun(vtkImageData* image, const PublishedDataSet& published)
{
  BenchRun run = { Method("steps", MapperKind::VarimarchShaders), {} };
  for (const PublishedSteps& row : published.steps)
  {
    RenderOptions options = PublishedLoop(image, false, 0.0);
    options.mostSteps = row.steps;
    run.settings.push_back(AtDistance(image, 1.0, options));
    run.settings.back().label = std::to_string(row.steps) + " steps";
  }
  return run;
}

// The loop along whole rays.
BenchRun WholeRun(vtkImageData* image, const std::string& name, bool hasField)
{
  BenchRun run = { Method(name, MapperKind::VarimarchShaders), {} };
  for (const double voxels : PublishedStepVoxels)
  {
    run.settings.push_back(
      AtDistance(image, voxels, PublishedLoop(image, hasField, PublishedVariation255)));
  }
  return run;
}

BenchRun ToleranceRun(const std::string& name, MapperKind kind)
{
  BenchRun run = { Method(name, kind), {} };
  for (const int part : { 4, 8, 16, 32, 64, 128, 255 })
  {
    run.settings.push_back({ "1/" + std::to_string(part), {} });
    run.settings.back().options.errorTolerance = 1.0 / part;
  }
  return run;
}

std::vector<BenchRun> BanqueroRuns(vtkImageData* image, const PublishedDataSet& published)
{
  std::vector<BenchRun> runs;
  if (!published.steps.empty())
  {
    runs.push_back(StepsRun(image, published));
  }
  if (published.rates)
  {
    runs.push_back(WholeRun(image, "rc", false));
    runs.push_back(WholeRun(image, "df", true));
    runs.push_back(ToleranceRun("tolerance", MapperKind::Varimarch));
    runs.push_back(ToleranceRun("tolerance-shader", MapperKind::VarimarchShaders));
  }
  return runs;
}

// Values up to 40 are clear; values from 41 share one opacity. The paper gives neither its unit
// distance, for which we use one voxel, nor the gradient below which it damps light.
Look VoltLook(vtkImageData* image, int alpha255, bool shaded)
{
  Look look;
  look.name = "Volt, alpha " + std::to_string(alpha255);
  look.colors = { { 41.0, { 0.75, 0.50, 0.40 }, {} }, { 255.0, { 1.0, 0.95, 0.85 }, {} } };
  look.opacities = { { 40.0, 0.0, {} }, { 41.0, alpha255 / 255.0, {} } };
  look.opacityUnitDistanceMm = VoxelMm(image);
  look.shading.enabled = shaded;
  look.dampingGradient = shaded ? VoltDampingPerVoxel / VoxelMm(image) : 0.0;
  return look;
}

// VTK's mapper has no damping, and is left out where there is some.
std::vector<BenchRun> VoltRuns(vtkImageData* image, bool shaded)
{
  constexpr double Voxels = 0.49;
  constexpr double Saturated = 0.05; // a saturation of 95 %
  const auto run = [&](const std::string& name, MapperKind kind, Acceleration acceleration)
  {
    RenderOptions options;
    options.acceleration = acceleration;
    options.integration = Integration::Midpoint;
    options.earlyTerminationTransmittance = Saturated;
    return BenchRun{ Method(name, kind), { AtDistance(image, Voxels, options) } };
  };
  std::vector<BenchRun> runs = { run("ours", MapperKind::Varimarch, Acceleration::OpticalField),
    run("off", MapperKind::Varimarch, Acceleration::Off) };
  if (!shaded)
  {
    runs.push_back(run("vtk-gpu", MapperKind::VtkGpu, Acceleration::Off));
  }
  return runs;
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
    LoadVolume(FileSource{ options.folder + "/" + VisMaleFile, std::nullopt });
  for (const int alpha255 : { 15, 63, 255 })
  {
    for (const bool shaded : { false, true })
    {
      const Look look = VoltLook(volume.image, alpha255, shaded);
      result.volt.push_back({ alpha255, shaded,
        Measured(look.name, look, volume, VoltRuns(volume.image, shaded), options, onStep) });
      onMeasured(result);
    }
  }
}

MeasuredDataSet MeasureDataSet(
  const PublishedDataSet& published, const PublishedOptions& options, const OnStep& onStep)
{
  const std::string path = options.folder + "/" + published.file;
  const std::string name = published.name + " " + std::to_string(published.side);
  onStep("Reading " + path);
  const LoadedVolume volume = LoadAtSize(path, published.side);
  MeasuredDataSet measured = { published,
    Measured(
      name, SoftLook(volume.image), volume, BanqueroRuns(volume.image, published), options, onStep),
    {} };
  if (published.rates)
  {
    onStep(name + ": jumps");
    measured.promise = TryJumps(volume.image, Variation(volume.image, PublishedVariation255));
  }
  return measured;
}

}

// The paper does not give its transfer function. The unit distance of opacity is a hundredth of the
// volume, and the opacity is low, because the paper's loop has no early termination.
Look SoftLook(vtkImageData* image)
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

RenderOptions PublishedLoop(vtkImageData* image, bool hasField, double variation255)
{
  RenderOptions options;
  options.acceleration = hasField ? Acceleration::VariationField : Acceleration::Off;
  options.integration = Integration::PublishedSum;
  options.variationTolerance = Variation(image, variation255);
  options.earlyTerminationTransmittance = 0.0;
  return options;
}

PublishedMeasurements MeasurePublished(
  const PublishedOptions& options, const OnStep& onStep, const OnPublished& onMeasured)
{
  PublishedMeasurements result;
  for (const PublishedDataSet& published : PublishedDataSets())
  {
    if (std::filesystem::exists(options.folder + "/" + published.file))
    {
      result.dataSets.push_back(MeasureDataSet(published, options, onStep));
      onMeasured(result);
    }
    else if (std::find(result.missing.begin(), result.missing.end(), published.file) ==
      result.missing.end())
    {
      result.missing.push_back(published.file);
    }
  }
  if (result.dataSets.empty())
  {
    throw std::runtime_error(
      options.folder + ": expected volumes such as " + VisMaleFile + ", found none");
  }
  if (std::filesystem::exists(options.folder + "/" + VisMaleFile))
  {
    AddVolt(options, onStep, onMeasured, result);
  }
  return result;
}

}
