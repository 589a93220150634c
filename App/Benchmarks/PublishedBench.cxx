#include "Published.h"

#include "Benchmark.h"
#include "CommandLine/Progress.h"
#include "Core/Fields/VariationField.h"
#include "Scene/Volumes/VolumeLoading.h"
#include "WorkPrecision.h"

#include <vtkImageResize.h>
#include <vtkImageShiftScale.h>
#include <vtkNew.h>

#include <CLI/CLI.hpp>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace varimarch
{

namespace
{

// The scenes on which two papers measured: Banquero's, tables 1 and 2, and "Volt: interactive
// volume rendering with CUDA", 2009. App/Benchmarks/Report says what is known of them and what we
// assume.

/// The steps of whole rays [smallest voxel spacings].
constexpr double PublishedStepVoxels[] = { 1.0, 0.5 };

/// Gradient below which Volt's light is damped here [units of the data, which are bytes, per
/// voxel].
constexpr double VoltDampingPerVoxel = 10.0;

/// A row of Banquero's table 1.
struct PublishedSteps
{
  int steps;
  double fps;
};

/// A row of Banquero's table 2, as printed.
struct PublishedRates
{
  std::string plainFps; ///< by ray casting
  std::string fieldFps; ///< with the distance field
  std::string ratio;    ///< the second over the first, as far as the table tells
};

/// A data set of Banquero's tables, and our volume for it.
struct PublishedDataSet
{
  std::string name;   ///< name in the paper
  int side;           ///< voxels along each axis
  std::string file;   ///< path in the folder of volumes
  std::string remark; ///< our volume before it was resampled
  std::vector<PublishedSteps> steps;
  std::optional<PublishedRates> rates;
};

// All data sets of Banquero's paper.
const std::vector<PublishedDataSet>& PublishedDataSets()
{
  static const std::vector<PublishedDataSet> all = {
    { "SKULL", 256, "ct_skull_phantom/dicom", "another skull, of plastic, 512 x 512 x 140",
      { { 40, 60.0 }, { 60, 59.8 }, { 80, 26.5 }, { 120, 11.1 } },
      PublishedRates{ "48", "59", "1.23" } },
    { "MRI HEAD", 256, "mr_head_studyforrest/mr_head_studyforrest_274x384x384_int16.mha",
      "another head, 274 x 384 x 384", { { 40, 60.0 }, { 60, 54.8 }, { 80, 23.2 }, { 120, 10.3 } },
      PublishedRates{ "50", "60", "1.20" } },
    { "VIS MALE", 128, VisMaleFile, "the same, 128 x 256 x 256", { { 80, 60.0 } },
      PublishedRates{ "45", "> 60", "> 1.33" } },
    { "VIS MALE", 256, VisMaleFile, "the same, 128 x 256 x 256", { { 120, 32.1 } }, std::nullopt },
    { "BONZAI", 256, "bonsai/bonsai_256x256x256_uint8.mhd", "the same", {},
      PublishedRates{ "30", "55", "1.83" } },
    { "TOOTH", 64, "tooth/tooth_103x94x161_uint8.mhd", "the same, 103 x 94 x 161", {},
      PublishedRates{ "> 60", "> 60", "not known" } },
  };
  return all;
}

// The range of values becomes that of a byte.
vtkSmartPointer<vtkImageData> Bytes(vtkImageData* image)
{
  const double* const range = image->GetScalarRange();
  vtkNew<vtkImageShiftScale> bytes;
  bytes->SetInputData(image);
  bytes->SetShift(-range[0]);
  bytes->SetScale(255.0 / std::max(range[1] - range[0], 1e-30));
  bytes->SetOutputScalarTypeToUnsignedChar();
  bytes->ClampOverflowOn();
  bytes->Update();
  return bytes->GetOutput();
}

/// Properties of the field of variations of a volume of bytes, and how often it is wrong about
/// interpolated values: a jump of d = S(p) from a position next to p should meet no value that
/// differs by E or more from that at its beginning.
struct PublishedPromise
{
  double buildSeconds;  ///< time to build the field of Euclidean distances
  double meanEuclidean; ///< mean distance [voxels]
  double meanChebyshev; ///< the same, if the surroundings are cubes
  double longJumps;     ///< part of the jumps that go 2 voxels or more, [0, 1]
  double brokenJumps;   ///< part of these that meet such a value, [0, 1]
  double largest;       ///< largest difference that they meet [units of the data]
};

constexpr int Jumps = 200000;
constexpr double StepVoxels = 0.25; // distance of the values that a jump is compared with

using Grid = ScalarGrid<unsigned char>;

double MeanOf(const VariationField& field)
{
  return std::accumulate(field.voxels.begin(), field.voxels.end(), 0.0) /
    double(field.voxels.size());
}

// The largest difference between the value at the beginning of a jump and those on its way.
double LargestOn(const Grid& grid, glm::dvec3 from, glm::dvec3 direction, double length)
{
  const glm::dvec3 last(grid.Dimensions() - 1);
  const double value = grid.Value(from);
  double largest = 0.0;
  for (double t = StepVoxels; t < length; t += StepVoxels)
  {
    const glm::dvec3 place = from + t * direction;
    if (glm::clamp(place, glm::dvec3(0.0), last) != place)
    {
      break; // the ray leaves the volume
    }
    largest = std::max(largest, std::abs(grid.Value(place) - value));
  }
  return largest;
}

void TryAllJumps(
  const Grid& grid, const VariationField& field, double tolerance, PublishedPromise& found)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  std::normal_distribution<double> normal;
  const glm::ivec3 count = grid.Dimensions();
  int longJumps = 0;
  int broken = 0;
  for (int i = 0; i < Jumps; ++i)
  {
    const glm::dvec3 from =
      glm::dvec3(part(random), part(random), part(random)) * glm::dvec3(count - 1);
    const glm::dvec3 direction =
      glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    const glm::ivec3 voxel(from + 0.5);
    const int distance =
      field.voxels[(std::size_t(voxel.z) * count.y + voxel.y) * count.x + voxel.x];
    if (distance < 2)
    {
      continue;
    }
    const double largest = LargestOn(grid, from, direction, distance);
    ++longJumps;
    broken += largest >= tolerance;
    found.largest = std::max(found.largest, largest);
  }
  found.longJumps = longJumps / double(Jumps);
  found.brokenJumps = longJumps > 0 ? broken / double(longJumps) : 0.0;
}

// Tries jumps from random positions in random directions.
// @param tolerance  E in units of the data
PublishedPromise TryJumps(vtkImageData* bytes, double tolerance)
{
  const int* const size = bytes->GetDimensions();
  const Grid grid(
    static_cast<unsigned char*>(bytes->GetScalarPointer()), { size[0], size[1], size[2] });
  PublishedPromise found = {};
  const auto start = std::chrono::steady_clock::now();
  const VariationField field = BuildVariationField(grid, tolerance, VoxelDistance::Euclidean);
  found.buildSeconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  found.meanEuclidean = MeanOf(field);
  found.meanChebyshev = MeanOf(BuildVariationField(grid, tolerance, VoxelDistance::Chebyshev));
  TryAllJumps(grid, field, tolerance, found);
  return found;
}

struct PublishedOptions
{
  std::string folder; ///< folder of the volumes; missing ones are skipped
  int side = 512;     ///< side of the square images [pixels]
  int rounds = 3;
};

BenchMethod MethodNamed(const std::string& name, MapperKind kind)
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
  BenchRun run = { MethodNamed("steps", MapperKind::VarimarchShaders), {} };
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
  BenchRun run = { MethodNamed(name, MapperKind::VarimarchShaders), {} };
  for (const double voxels : PublishedStepVoxels)
  {
    run.settings.push_back(
      AtDistance(image, voxels, PublishedLoop(image, hasField, PublishedVariation255)));
  }
  return run;
}

BenchRun ToleranceRun(const std::string& name, MapperKind kind)
{
  BenchRun run = { MethodNamed(name, kind), {} };
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
    return BenchRun{ MethodNamed(name, kind), { AtDistance(image, Voxels, options) } };
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

nlohmann::ordered_json JsonOfPaper(const PublishedDataSet& published)
{
  nlohmann::ordered_json json = { { "dataSet", published.name }, { "side", published.side },
    { "file", published.file }, { "remark", published.remark } };
  for (const PublishedSteps& row : published.steps)
  {
    json["theirSteps"].push_back({ { "steps", row.steps }, { "fps", row.fps } });
  }
  if (published.rates)
  {
    json["theirRates"] = { { "plainFps", published.rates->plainFps },
      { "fieldFps", published.rates->fieldFps }, { "ratio", published.rates->ratio } };
  }
  return json;
}

// Our measurements on one data set. The method "steps" has one point for each row of table 1, and
// "rc" and "df" have one for each of PublishedStepVoxels; "tolerance" and "tolerance-shader" are
// swept over error tolerances.
nlohmann::ordered_json MeasureDataSet(
  const PublishedDataSet& published, const PublishedOptions& options, const OnStep& onStep)
{
  const std::string path = options.folder + "/" + published.file;
  const std::string name = published.name + " " + std::to_string(published.side);
  onStep("Reading " + path);
  const LoadedVolume volume = LoadAtSize(path, published.side);
  nlohmann::ordered_json json = JsonOfPaper(published);
  json["measured"] = ToJson(Measured(
    name, SoftLook(volume.image), volume, BanqueroRuns(volume.image, published), options, onStep));
  if (published.rates)
  {
    onStep(name + ": jumps");
    const PublishedPromise promise =
      TryJumps(volume.image, Variation(volume.image, PublishedVariation255));
    json.update(
      { { "buildSeconds", promise.buildSeconds }, { "meanEuclidean", promise.meanEuclidean },
        { "meanChebyshev", promise.meanChebyshev }, { "longJumps", promise.longJumps },
        { "brokenJumps", promise.brokenJumps }, { "largestDifference", promise.largest } });
  }
  return json;
}

void WritePublished(BenchResults& results)
{
  results.Write(std::to_string(results.json["banquero"].size() + results.json["volt"].size()) +
    " of the scenes");
}

// The scenes of Banquero's paper whose volumes are in the folder.
void MeasureBanquero(const PublishedOptions& options, const OnStep& onStep, BenchResults& results)
{
  nlohmann::ordered_json& missing = results.json["missing"] = nlohmann::ordered_json::array();
  for (const PublishedDataSet& published : PublishedDataSets())
  {
    if (std::filesystem::exists(options.folder + "/" + published.file))
    {
      results.json["banquero"].push_back(MeasureDataSet(published, options, onStep));
      WritePublished(results);
    }
    else if (std::find(missing.begin(), missing.end(), published.file) == missing.end())
    {
      missing.push_back(published.file);
    }
  }
  if (!results.json.contains("banquero"))
  {
    throw std::runtime_error(
      options.folder + ": expected volumes such as " + VisMaleFile + ", found none");
  }
}

// VIS MALE with Volt's opacities: the methods "ours", "off" and, where no light is damped,
// "vtk-gpu" at Volt's sample distance.
void MeasureVolt(const PublishedOptions& options, const OnStep& onStep, BenchResults& results)
{
  const LoadedVolume volume =
    LoadVolume(FileSource{ options.folder + "/" + VisMaleFile, std::nullopt });
  for (const int alpha255 : { 15, 63, 255 })
  {
    for (const bool shaded : { false, true })
    {
      const Look look = VoltLook(volume.image, alpha255, shaded);
      results.json["volt"].push_back({ { "alpha255", alpha255 }, { "shaded", shaded },
        { "measured",
          ToJson(Measured(
            look.name, look, volume, VoltRuns(volume.image, shaded), options, onStep)) } });
      WritePublished(results);
    }
  }
}

void AddPublishedOptions(CLI::App& command, PublishedOptions& options)
{
  command
    .add_option("--volumes", options.folder,
      "The folder of the papers' volumes (default: $VARIMARCH_VOLUMES)")
    ->envname("VARIMARCH_VOLUMES")
    ->check(CLI::ExistingDirectory.description(""))
    ->type_name("FOLDER")
    ->required();
  AddSideOption(command, options.side);
  AddRoundsOption(command, options.rounds);
}

void RunPublished(const PublishedOptions& options, BenchResults& results)
{
  constexpr int LargestSide = 256; // side of each picture in a figure [pixels]
  Progress progress("Measuring the published scenes");
  const OnStep onStep = [&](const std::string& step) { progress.SetActivity(step); };
  results.json["stepVoxels"] = PublishedStepVoxels;
  for (const PublishedFigure& figure : DrawPublishedFigures(
         options.folder, std::min(options.side, LargestSide), results.Folder(), onStep))
  {
    results.json["figures"].push_back({ { "file", figure.file }, { "text", figure.text } });
  }
  MeasureBanquero(options, onStep, results);
  if (std::filesystem::exists(options.folder + "/" + VisMaleFile))
  {
    MeasureVolt(options, onStep, results);
  }
}

}

Benchmark PublishedBenchmark()
{
  return MakeBenchmark("published",
    "Measure the scenes of two papers beside their published figures",
    "Scenes: Banquero, Ortiz, Rossi 2016, tables 1 and 2, and Volt 2009. Volumes that\n"
    "are missing in the folder are skipped and listed.\n"
    "Example:\n"
    "  varimarch-bench published --volumes volumes -o published",
    AddPublishedOptions, RunPublished);
}

const char* const VisMaleFile = "vismale/vismale_128x256x256_uint8.mhd";

LoadedVolume LoadAtSize(const std::string& path, int side)
{
  LoadedVolume volume = LoadVolume(FileSource{ path, std::nullopt });
  vtkNew<vtkImageResize> resize;
  resize->SetInputData(volume.image);
  resize->SetOutputDimensions(side, side, side);
  resize->Update();
  const auto resized = Bytes(resize->GetOutput());
  resized->SetDirectionMatrix(volume.image->GetDirectionMatrix());
  volume.image = resized;
  return volume;
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

}
