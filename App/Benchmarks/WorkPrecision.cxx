#include "WorkPrecision.h"

#include "Benchmark.h"
#include "CommandLine/Parser.h"
#include "CommandLine/Progress.h"
#include "CommandLine/ReportedErrors.h"
#include "CommandLine/Results.h"
#include "CommandLine/SceneArguments.h"
#include "Core/Quality/ImageError.h"
#include "Scene/Images/DifferencePicture.h"
#include "Scene/Images/ImageFiles.h"
#include "Scene/Json/SceneNames.h"
#include "Scene/Median.h"

#include <vtkCamera.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <memory>

namespace varimarch
{

namespace
{

// The sample distance of a point in smallest voxel spacings.
double VoxelsOf(const WorkPrecision& scene, const WorkPoint& point)
{
  return point.sampleDistanceMm / VoxelMm(scene.volume.image);
}

using Pixels = std::vector<float>;

void Turn(MethodView& view, double degrees)
{
  vtkRenderer* const renderer = view.Offscreen().Pipeline().Renderer();
  renderer->GetActiveCamera()->Azimuth(degrees);
  renderer->ResetCameraClippingRange();
}

Pixels PixelsOf(MethodView& view)
{
  const auto picture = view.Offscreen().FloatImage();
  const auto* const channels = static_cast<const float*>(picture->GetScalarPointer());
  return Pixels(channels, channels + 4 * picture->GetNumberOfPoints());
}

Pixels Less(Pixels pixels, const Pixels& fine)
{
  std::transform(pixels.begin(), pixels.end(), fine.begin(), pixels.begin(), std::minus<float>());
  return pixels;
}

RenderOptions FineOptions(vtkImageData* image)
{
  RenderOptions options;
  options.earlyTerminationTransmittance = 0.0;
  return AtDistance(image, 0.125, options).options;
}

// A method on its way through an orbit.
struct OrbitingView
{
  MethodView* view;
  Pixels error; ///< the error of the last frame; empty before the first
  std::vector<double> changes;

  void TakeFrame(const Pixels& fine)
  {
    Pixels next = Less(PixelsOf(*this->view), fine);
    if (!this->error.empty())
    {
      this->changes.push_back(
        CompareImages(next.data(), this->error.data(), next.size() / 4).rootMeanSquare);
    }
    this->error = std::move(next);
  }
};

}

std::vector<OrbitChange> ChangesInOrbit(const std::vector<MethodView*>& views, const Scene& scene,
  vtkImageData* image, int frames, const OnStep& onStep)
{
  MethodView fineView({ "fine", "fine frames", MapperKind::Varimarch, {} }, scene, image);
  fineView.SetOptions(FineOptions(image));
  const double degrees = OrbitDegrees / (frames - 1);
  std::vector<OrbitingView> orbiting;
  for (MethodView* const view : views)
  {
    view->Offscreen().Render(); // VTK's GPU mapper draws its first frame only into the window
    orbiting.push_back({ view, {}, {} });
  }
  for (int frame = 0; frame < frames; ++frame)
  {
    onStep("frame " + std::to_string(frame + 1) + " of " + std::to_string(frames) + " of an orbit");
    const Pixels fine = PixelsOf(fineView);
    for (OrbitingView& one : orbiting)
    {
      one.TakeFrame(fine);
      Turn(*one.view, frame + 1 < frames ? degrees : -OrbitDegrees);
    }
    Turn(fineView, degrees);
  }
  std::vector<OrbitChange> summaries;
  for (const OrbitingView& one : orbiting)
  {
    summaries.push_back(SummaryOf(one.changes));
  }
  return summaries;
}

namespace
{

/// Measures one method on a scene.
struct Runner
{
  WorkCurve curve;
  std::unique_ptr<MethodView> view;

  /// The time of a frame, drawn after another one that built what the setting needs [s].
  double SecondsOf(const BenchSetting& setting)
  {
    this->view->SetOptions(setting.options);
    this->view->Offscreen().Render();
    return this->view->Offscreen().Render();
  }
};

bool HoldsEightBitsOnly(vtkImageData* picture)
{
  // This is far above the error of rounding n / 255 to a float.
  constexpr double Slack = 1e-4;
  const auto* channels = static_cast<const float*>(picture->GetScalarPointer());
  return std::all_of(channels, channels + 4 * picture->GetNumberOfPoints(),
    [](float channel)
    {
      const double level = 255.0 * channel;
      return std::abs(level - std::round(level)) < Slack;
    });
}

// The RMSE of rounding alone. An 8-bit image has a smaller error only by chance.
double EightBitRmse(vtkImageData* truth)
{
  const auto* channels = static_cast<const float*>(truth->GetScalarPointer());
  const vtkIdType count = 4 * truth->GetNumberOfPoints();
  double sum = 0.0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double level = 255.0 * channels[i];
    sum += (level - std::round(level)) * (level - std::round(level));
  }
  return std::sqrt(sum / double(count));
}

// Draws one setting, measures its error, and returns the time of a frame [s].
double AddPoint(Runner& runner, const BenchSetting& setting, const WorkPrecision& result)
{
  constexpr double NearOneVoxel = 0.99; // VTK's mappers round distances to float
  const double seconds = runner.SecondsOf(setting);
  MethodView& view = *runner.view;
  const auto picture = view.Offscreen().FloatImage();
  ThrowIfVtkReportedError();
  WorkCurve& curve = runner.curve;
  curve.eightBits = HoldsEightBitsOnly(picture) && (curve.points.empty() || curve.eightBits);
  curve.points.push_back({ setting, view.UsedSampleDistanceMm(), view.EstimatedError(),
    ErrorOf(picture, result.truth.picture, result.scene.background), view.Fetches(), view.Bytes(),
    {}, 0.0 });
  if (!curve.picture || VoxelsOf(result, curve.points.back()) >= NearOneVoxel)
  {
    curve.picture = picture;
    curve.shown = curve.points.size() - 1;
  }
  return seconds;
}

Runner StartedRunner(const BenchRun& run, const WorkPrecision& result,
  const MeasuringOptions& options, const OnStep& onStep)
{
  Runner runner = { { run.method, {}, {}, false, 0, nullptr, {} },
    std::make_unique<MethodView>(run.method, result.scene, result.volume.image) };
  double seconds = 0.0;
  for (const BenchSetting& setting : run.settings)
  {
    if (seconds > options.longestSeconds)
    {
      runner.curve.skipped = setting.label + " and finer: an image at " +
        runner.curve.points.back().setting.label + " took " + Fixed(seconds, 1) +
        " s, more than the " + Fixed(options.longestSeconds, 1) + " s allowed";
      break;
    }
    onStep(result.name + ": errors of " + run.method.name + " at " + setting.label);
    seconds = AddPoint(runner, setting, result);
  }
  return runner;
}

// The setting that a curve's picture shows, of all methods on the same orbit.
void MeasureOrbits(
  std::vector<Runner>& runners, const WorkPrecision& result, int frames, const OnStep& onStep)
{
  std::vector<MethodView*> views;
  for (Runner& runner : runners)
  {
    runner.view->SetOptions(runner.curve.points[runner.curve.shown].setting.options);
    views.push_back(runner.view.get());
  }
  const std::vector<OrbitChange> changes = ChangesInOrbit(views, result.scene, result.volume.image,
    frames, [&](const std::string& step) { onStep(result.name + ": " + step); });
  for (std::size_t i = 0; i < runners.size(); ++i)
  {
    runners[i].curve.orbit = changes[i];
  }
}

// The tolerance of a point; empty if it has a sample distance instead.
std::optional<double> ToleranceOf(const WorkPoint& point)
{
  const RenderOptions& options = point.setting.options;
  return options.sampleDistanceMm ? std::nullopt : std::optional<double>(options.errorTolerance);
}

nlohmann::ordered_json ToJson(const WorkPrecision& scene, const WorkPoint& point)
{
  nlohmann::ordered_json json = { { "setting", point.setting.label },
    { "voxels", VoxelsOf(scene, point) }, { "sampleDistanceMm", point.sampleDistanceMm } };
  if (const auto tolerance = ToleranceOf(point))
  {
    json["errorTolerance"] = *tolerance;
    json["estimatedError"] = point.estimatedError;
  }
  json.update(ToJson(point.error));
  if (point.fetchesPerPixel)
  {
    json["fetchesPerPixel"] = *point.fetchesPerPixel;
  }
  if (point.graphicsBytes)
  {
    json["graphicsBytes"] = *point.graphicsBytes;
  }
  json["roundsMs"] = point.roundsMs;
  json["medianMs"] = point.medianMs;
  return json;
}

nlohmann::ordered_json ToJson(const WorkPrecision& scene, const WorkCurve& curve)
{
  nlohmann::ordered_json json = { { "method", curve.method.name }, { "title", curve.method.title },
    { "renderer", NameOf(MapperKindNames(), curve.method.kind) }, { "eightBits", curve.eightBits },
    { "skipped", curve.skipped }, { "shown", curve.shown } };
  for (const WorkPoint& point : curve.points)
  {
    json["points"].push_back(ToJson(scene, point));
  }
  if (curve.orbit)
  {
    json["orbit"] = { { "setting", curve.points[curve.shown].setting.label },
      { "frames", curve.orbit->frames }, { "degreesPerFrame", curve.orbit->degreesPerFrame },
      { "medianChange255", curve.orbit->median }, { "largestChange255", curve.orbit->largest },
      { "largestAtDegrees", curve.orbit->largestAtDegrees } };
  }
  return json;
}

struct WorkPrecisionOptions
{
  SceneArguments scene;
  std::vector<std::string> inputs;
  std::vector<std::string> methods; ///< empty: all
  MeasuringOptions measuring;
};

void AddWorkPrecisionOptions(CLI::App& command, WorkPrecisionOptions& options)
{
  command
    .add_option("SCENES", options.inputs,
      "Scene files (.json), volume files, DICOM folders, or procedural:NAME[:XxYxZ]")
    ->required();
  AddLookAndPictureOptions(command, options.scene);
  command.add_option("--methods", options.methods, "Methods to measure (default all)")
    ->delimiter(',')
    ->check(OneOf(BenchMethodNames()));
  AddRoundsOption(command, options.measuring.rounds);
  AddLongestOption(command, options.measuring.longestSeconds,
    "Skip finer settings once an image takes longer (default 3)");
  command
    .add_option("--orbit", options.measuring.orbitFrames,
      "Frames of an orbit in which changes of the error are measured (default 31), or 0")
    ->check(CLI::IsMember({ 0 }).description("") | CLI::Range(2, 10000).description(""))
    ->type_name("FRAMES");
}

// A unique name for a scene, made from its input and usable as a file name.
std::string SceneName(const std::string& input, const nlohmann::ordered_json& others)
{
  std::string name = std::filesystem::path(input).stem().string();
  std::replace_if(
    name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c) && c != '-'; }, '-');
  const auto taken = [&](const std::string& candidate)
  {
    return std::any_of(others.begin(), others.end(),
      [&](const nlohmann::ordered_json& other) { return other["name"] == candidate; });
  };
  std::string unique = name;
  for (int number = 2; taken(unique); ++number)
  {
    unique = name + "-" + std::to_string(number);
  }
  return unique;
}

// Writes the truth, the image of each method at about one sample per voxel, its difference from the
// truth, and the scale of the differences.
void WritePictures(const WorkPrecision& scene, const std::filesystem::path& folder)
{
  constexpr int ScaleWidth = 512; // pixels
  const auto write = [&](const std::string& name, vtkImageData* picture)
  { WritePng(picture, (folder / (name + ".png")).string()); };
  Canvas scale(ScaleWidth, DifferenceScaleHeight, { 255, 255, 255 });
  DrawDifferenceScale(scale, 0, 0, ScaleWidth);
  write("difference-scale", scale.Picture());
  write(scene.name + "-truth", BytesOver(scene.truth.picture, scene.scene.background));
  for (const WorkCurve& curve : scene.curves)
  {
    const std::string name = scene.name + "-" + curve.method.name;
    write(name, BytesOver(curve.picture, scene.scene.background));
    write(name + "-difference", DifferencePicture(curve.picture, scene.truth.picture));
  }
}

void RunWorkPrecision(const WorkPrecisionOptions& options, BenchResults& results)
{
  for (const std::string& input : options.inputs)
  {
    const auto [scene, volume] = LoadScene(options.scene, input);
    Progress progress("Measuring " + input);
    const WorkPrecision measured = MeasureRuns(SceneName(input, results.json["scenes"]), scene,
      volume, WorkPrecisionRuns(scene, volume.image, options.methods), options.measuring,
      [&](const std::string& step) { progress.SetActivity(step); });
    WritePictures(measured, results.Folder());
    ThrowIfVtkReportedError();
    results.json["scenes"].push_back(ToJson(measured));
    results.Write(std::to_string(results.json["scenes"].size()) + " of " +
      std::to_string(options.inputs.size()) + " scenes");
  }
}

}

Benchmark WorkPrecisionBenchmark()
{
  WorkPrecisionOptions defaults;
  defaults.measuring.orbitFrames = 31;
  return MakeBenchmark("work-precision",
    "Measure error against run time of our mapper's settings and of VTK's mappers",
    "Writes results and images after each scene, so an interrupted run keeps what it has.\n"
    "Examples:\n"
    "  varimarch-bench work-precision head.nii.gz -o report --size 256x256\n"
    "  varimarch-bench work-precision Data/Scenes/*.json -o report --rounds 5\n"
    "  varimarch-bench work-precision scene.json -o report --methods optical,vtk-gpu",
    AddWorkPrecisionOptions, RunWorkPrecision, defaults);
}

WorkPrecision MeasureRuns(const std::string& name, const Scene& scene, const LoadedVolume& volume,
  const std::vector<BenchRun>& runs, const MeasuringOptions& options, const OnStep& onStep)
{
  WorkPrecision result = { name, scene, volume, {}, 0.0, {}, {} };
  result.truth =
    TruthOf(scene, volume.image, [&](const std::string& step) { onStep(name + ": " + step); });
  result.eightBitRmse = EightBitRmse(result.truth.picture);

  std::vector<Runner> runners;
  for (const BenchRun& run : runs)
  {
    runners.push_back(StartedRunner(run, result, options, onStep));
  }
  for (int round = 1; round <= options.rounds; ++round)
  {
    for (Runner& runner : runners)
    {
      onStep(name + ": times of " + runner.curve.method.name + ", round " + std::to_string(round) +
        " of " + std::to_string(options.rounds));
      for (WorkPoint& point : runner.curve.points)
      {
        point.roundsMs.push_back(1000.0 * runner.SecondsOf(point.setting));
      }
    }
  }
  if (options.orbitFrames > 0)
  {
    MeasureOrbits(runners, result, options.orbitFrames, onStep);
  }
  ThrowIfVtkReportedError();
  for (Runner& runner : runners)
  {
    for (WorkPoint& point : runner.curve.points)
    {
      point.medianMs = Median(point.roundsMs);
    }
    result.openglRenderer = runner.view->Offscreen().DeviceName();
    result.curves.push_back(runner.curve);
  }
  return result;
}

OrbitChange SummaryOf(const std::vector<double>& changes)
{
  const auto largest = std::max_element(changes.begin(), changes.end());
  const int frames = int(changes.size()) + 1;
  const double degrees = OrbitDegrees / double(changes.size());
  return { frames, degrees, Median(changes), *largest,
    degrees * double(largest - changes.begin() + 1) };
}

nlohmann::ordered_json ToJson(const WorkPrecision& scene)
{
  nlohmann::ordered_json json = ResultsOf("", scene.volume);
  json.erase("command");
  json.update(
    { { "name", scene.name }, { "size", scene.scene.size }, { "look", scene.scene.look.name },
      { "shaded", scene.scene.look.shading.enabled }, { "openglRenderer", scene.openglRenderer },
      { "reference",
        { { "largestError255", 255.0 * scene.truth.largestError },
          { "seconds", scene.truth.seconds }, { "text", Described(scene.truth) } } },
      { "eightBitRmse255", scene.eightBitRmse } });
  for (const WorkCurve& curve : scene.curves)
  {
    json["methods"].push_back(ToJson(scene, curve));
  }
  return json;
}

}
