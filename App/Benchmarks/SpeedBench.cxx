#include "BenchMethods.h"
#include "BenchScenes.h"
#include "CommandLine/Parser.h"
#include "CommandLine/PictureError.h"
#include "CommandLine/Results.h"
#include "FrameCost.h"
#include "Scene/Json/SceneNames.h"
#include "Scene/Median.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace varimarch
{

namespace
{

/// A method's measurements on one scene.
struct SpeedPoint
{
  std::string method; ///< "ours", "off", each also "-shader", "published", "vtk-gpu" or "vtk-cpu"
  MapperKind kind;
  RenderOptions options;
  double firstSeconds;                   ///< time of the first frame
  ImageError error;                      ///< error against the truth
  std::optional<double> fetchesPerPixel; ///< see FrameCost.h
  std::optional<double> graphicsBytes;   ///< see FrameCost.h
  std::vector<FrameCost>
    rounds;         ///< one per comparison and round; without comparisons one per round
  FrameCost median; ///< median of the rounds
};

/// A goal: to be faster than another method by a factor, at an error of at most a fraction of its
/// error.
struct SpeedTarget
{
  std::string title;
  std::string rival;   ///< method to compare with
  std::string ours;    ///< our method, marched on the same device as the rival
  double partOfError;  ///< limit of our RMSE, as a fraction of the rival's
  double timesWanted;  ///< speed-up over the rival, geometric mean of all scenes
  double timesAtLeast; ///< speed-up on every scene; 0: no goal
};

/// All measurements on one scene at one size.
struct SpeedCase
{
  std::string scene;
  bool shaded;
  int side;                       ///< side of the square image [pixels]
  std::vector<SpeedPoint> points; ///< points: default settings first, then ours at other tolerances
  /// Index of our point with the largest tolerance that keeps the error of each target; empty if
  /// none does, or if the rival does not apply to the scene.
  std::vector<std::optional<std::size_t>> keeping;
  /// Speed-up in each round over each target's rival. Both were drawn one right after the other.
  std::vector<std::vector<double>> timesAsFast;
  std::string openglRenderer;
};

struct SpeedOptions
{
  BenchSceneOptions scenes;
  std::vector<int> sides = { 256, 512, 1024 };
  std::vector<bool> shaded = { false, true };
  int rounds = 3;
  double longestSeconds = 20.0; ///< time above which frames are drawn in one round only
};

const std::vector<SpeedTarget>& SpeedTargets()
{
  static const std::vector<SpeedTarget> targets = {
    { "VTK's GPU mapper, RMSE lower", "vtk-gpu", "ours", 1.0, 15.0, 4.0 },
    { "VTK's fixed-point mapper, RMSE 5 times lower", "vtk-cpu", "ours", 0.2, 2.0, 0.0 },
    { "no field, same RMSE", "off", "ours", 1.0, 5.0, 1.0 },
    { "no field, same RMSE, both by shaders", "off-shader", "ours-shader", 1.0, 5.0, 1.0 },
    { "published method, same RMSE", "published", "ours", 1.0, 3.0, 0.0 },
    { "published method, same RMSE, both by shaders", "published", "ours-shader", 1.0, 3.0, 0.0 },
  };
  return targets;
}

const SpeedPoint* Rival(const SpeedCase& measured, const SpeedTarget& target)
{
  const auto rival = std::find_if(measured.points.begin(), measured.points.end(),
    [&](const SpeedPoint& point) { return point.method == target.rival; });
  return rival == measured.points.end() ? nullptr : &*rival;
}

std::optional<double> TimesAsFast(const SpeedCase& measured, std::size_t target)
{
  const std::vector<double>& rounds = measured.timesAsFast[target];
  return rounds.empty() ? std::nullopt : std::optional<double>(Median(rounds));
}

/// Measures one scene at one size.
struct Bench
{
  const Scene& scene;
  vtkImageData* image;
  const Truth& truth;
  const SpeedOptions& options;
  const OnStep& onStep;

  OffscreenView NewView(MapperKind kind, const RenderOptions& render) const
  {
    Scene drawn = this->scene;
    drawn.render = render;
    return OffscreenView(drawn, this->image, kind);
  }

  ImageError ErrorOf(OffscreenView& view) const
  {
    const auto picture = view.FloatImage();
    return CompareImages(static_cast<const float*>(picture->GetScalarPointer()),
      static_cast<const float*>(this->truth.picture->GetScalarPointer()),
      std::size_t(picture->GetNumberOfPoints()));
  }

  // Measures a point without any rounds.
  SpeedPoint PointOf(const std::string& method, MapperKind kind, const RenderOptions& render) const
  {
    this->onStep("error of " + method);
    OffscreenView view = this->NewView(kind, render);
    SpeedPoint point = { method, kind, render, view.Render(), {}, {}, {}, {}, {} };
    point.error = this->ErrorOf(view);
    point.graphicsBytes = GraphicsBytes(view);
    point.fetchesPerPixel = FetchesPerPixel(view);
    return point;
  }

  bool IsDrawnIn(int round, const SpeedPoint& point) const
  {
    return round == 1 || point.firstSeconds <= this->options.longestSeconds;
  }

  void AddRound(int round, SpeedPoint& point) const
  {
    this->onStep("times of " + point.method + ", round " + std::to_string(round) + " of " +
      std::to_string(this->options.rounds));
    OffscreenView view = this->NewView(point.kind, point.options);
    point.rounds.push_back(CostOfFrames(view, this->scene.look));
  }

  // Draws both one right after the other, so that a slow moment of the machine affects both alike.
  // Short frames are repeated, because a disturbance takes longer than one of them.
  // @return our speed-up in each repetition
  std::vector<double> Compare(int round, SpeedPoint& rival, SpeedPoint& ours) const
  {
    constexpr double ShortMs = 5.0;
    constexpr std::size_t TimesIfShort = 3;
    std::vector<double> timesAsFast;
    do
    {
      const bool isRivalFirst = (round + timesAsFast.size()) % 2 == 1;
      this->AddRound(round, isRivalFirst ? rival : ours);
      this->AddRound(round, isRivalFirst ? ours : rival);
      timesAsFast.push_back(rival.rounds.back().stillMs / ours.rounds.back().stillMs);
    } while (ours.rounds.back().stillMs < ShortMs && timesAsFast.size() < TimesIfShort);
    return timesAsFast;
  }

  void AddComparisons(int round, SpeedCase& measured) const
  {
    for (std::size_t target = 0; target < SpeedTargets().size(); ++target)
    {
      if (!measured.keeping[target])
      {
        continue;
      }
      const SpeedPoint* const found = Rival(measured, SpeedTargets()[target]);
      SpeedPoint& rival = measured.points[std::size_t(found - measured.points.data())];
      SpeedPoint& ours = measured.points[*measured.keeping[target]];
      if (this->IsDrawnIn(round, rival) && this->IsDrawnIn(round, ours))
      {
        const std::vector<double> timesAsFast = this->Compare(round, rival, ours);
        measured.timesAsFast[target].insert(
          measured.timesAsFast[target].end(), timesAsFast.begin(), timesAsFast.end());
      }
    }
  }

  void AddRounds(SpeedCase& measured) const
  {
    measured.timesAsFast.resize(SpeedTargets().size());
    for (int round = 1; round <= this->options.rounds; ++round)
    {
      this->AddComparisons(round, measured);
      for (SpeedPoint& point : measured.points)
      {
        if (int(point.rounds.size()) < round && this->IsDrawnIn(round, point))
        {
          this->AddRound(round, point); // it belongs to no target
        }
      }
    }
    for (SpeedPoint& point : measured.points)
    {
      point.median = MedianOf(point.rounds);
    }
  }
};

RenderOptions Tolerating(double errorTolerance, Acceleration acceleration)
{
  RenderOptions options;
  options.errorTolerance = errorTolerance;
  options.acceleration = acceleration;
  return options;
}

std::vector<SpeedPoint> DefaultPoints(const Bench& bench)
{
  const double tolerance = RenderOptions().errorTolerance;
  RenderOptions everyVoxel;
  everyVoxel.sampleDistanceMm = VoxelMm(bench.image);
  RenderOptions published = everyVoxel;
  published.acceleration = Acceleration::VariationField;
  published.integration = Integration::PublishedSum;
  published.variationTolerance = Variation(bench.image, 4.0); // its authors' choice, in 1/255

  constexpr MapperKind Ours = MapperKind::Varimarch;
  std::vector<SpeedPoint> points;
  points.push_back(bench.PointOf("ours", Ours, Tolerating(tolerance, Acceleration::OpticalField)));
  points.push_back(bench.PointOf("off", Ours, Tolerating(tolerance, Acceleration::Off)));
  constexpr MapperKind Shaders = MapperKind::VarimarchShaders;
  points.push_back(
    bench.PointOf("ours-shader", Shaders, Tolerating(tolerance, Acceleration::OpticalField)));
  points.push_back(bench.PointOf("off-shader", Shaders, Tolerating(tolerance, Acceleration::Off)));
  if (!bench.scene.look.shading.enabled && bench.scene.look.blend == Blend::Composite)
  {
    points.push_back(bench.PointOf("published", Shaders, published));
  }
  points.push_back(bench.PointOf("vtk-gpu", MapperKind::VtkGpu, everyVoxel));
  if (CanBlend(MapperKind::VtkCpu, bench.scene.look.blend))
  {
    points.push_back(bench.PointOf("vtk-cpu", MapperKind::VtkCpu, everyVoxel));
  }
  return points;
}

/// One of our tolerances and the resulting error.
struct Rung
{
  double tolerance;
  double rmse; ///< [1/255]
};

MapperKind KindOf(const std::string& method)
{
  return method == "ours" ? MapperKind::Varimarch : MapperKind::VarimarchShaders;
}

constexpr double Coarsest = 1.0;
constexpr double RungsPerHalf = 4.0;

// Measures the tolerances of one of our methods from coarse to fine, until the RMSE is at most
// `lowest` or a frame takes too long.
std::vector<Rung> Ladder(const Bench& bench, const std::string& method, double lowest)
{
  constexpr int Finest = 40; // a tolerance of 1/1024
  std::vector<Rung> rungs;
  OffscreenView view =
    bench.NewView(KindOf(method), Tolerating(Coarsest, Acceleration::OpticalField));
  for (int i = 0; i <= Finest; ++i)
  {
    const double tolerance = Coarsest * std::pow(2.0, -i / RungsPerHalf);
    bench.onStep("error of " + method + " at a tolerance of 1/" + Fixed(1.0 / tolerance, 0));
    view.Pipeline().SetRenderOptions(Tolerating(tolerance, Acceleration::OpticalField));
    const double seconds = view.Render();
    rungs.push_back({ tolerance, bench.ErrorOf(view).rootMeanSquare });
    if (rungs.back().rmse <= lowest || seconds > bench.options.longestSeconds)
    {
      break;
    }
  }
  return rungs;
}

// Finds approximately the largest tolerance whose RMSE is at most `wanted`. It lies between a rung
// that reaches it and fifteen sixteenths of the way to the next coarser rung.
double LargestTolerance(const Bench& bench, const std::string& method, double rung, double wanted)
{
  if (rung == Coarsest)
  {
    return rung;
  }
  OffscreenView view = bench.NewView(KindOf(method), Tolerating(rung, Acceleration::OpticalField));
  double largest = rung;
  for (const double partOfRung : { 0.5, 0.25, 0.125, 0.0625 })
  {
    const double tolerance = largest * std::pow(2.0, partOfRung / RungsPerHalf);
    view.Pipeline().SetRenderOptions(Tolerating(tolerance, Acceleration::OpticalField));
    view.Render();
    largest = bench.ErrorOf(view).rootMeanSquare <= wanted ? tolerance : largest;
  }
  return largest;
}

// The index of our method's point at a tolerance. The point is measured if it does not exist yet.
std::size_t PointAt(
  const Bench& bench, const std::string& method, double tolerance, std::vector<SpeedPoint>& points)
{
  const auto found = std::find_if(points.begin(), points.end(),
    [&](const SpeedPoint& point)
    { return point.method == method && point.options.errorTolerance == tolerance; });
  const std::size_t index = std::size_t(found - points.begin());
  if (found == points.end())
  {
    points.push_back(
      bench.PointOf(method, KindOf(method), Tolerating(tolerance, Acceleration::OpticalField)));
  }
  return index;
}

// The largest RMSE that a target allows us [1/255]; empty if the rival was not measured.
std::optional<double> WantedError(const SpeedCase& measured, const SpeedTarget& target)
{
  const SpeedPoint* rival = Rival(measured, target);
  return rival ? std::optional<double>(target.partOfError * rival->error.rootMeanSquare)
               : std::nullopt;
}

// Finds the points that meet the error limits of the targets.
void KeepErrors(const Bench& bench, SpeedCase& measured)
{
  std::map<std::string, double> lowest; // lowest RMSE that each of our methods must reach
  for (const SpeedTarget& target : SpeedTargets())
  {
    if (const std::optional<double> wanted = WantedError(measured, target))
    {
      const auto found = lowest.emplace(target.ours, *wanted).first;
      found->second = std::min(found->second, *wanted);
    }
  }
  std::map<std::string, std::vector<Rung>> ladders;
  for (const auto& [method, error] : lowest)
  {
    ladders[method] = Ladder(bench, method, error);
  }
  for (const SpeedTarget& target : SpeedTargets())
  {
    const std::vector<Rung>& rungs = ladders[target.ours];
    const std::optional<double> wanted = WantedError(measured, target);
    const auto rung = std::find_if(rungs.begin(), rungs.end(),
      [&](const Rung& candidate) { return wanted && candidate.rmse <= *wanted; });
    if (rung == rungs.end())
    {
      measured.keeping.push_back(std::nullopt);
      continue;
    }
    const double tolerance = LargestTolerance(bench, target.ours, rung->tolerance, *wanted);
    measured.keeping.push_back(PointAt(bench, target.ours, tolerance, measured.points));
  }
}

/// Draws a scene at each size, shaded and not, in rounds: each method at its default setting, and
/// ours also at the error tolerances that the targets need. The two methods of a target are drawn
/// one right after the other, in alternating order, each in a new window with a new mapper.
/// @throws std::runtime_error when a mapper reports an error
std::vector<SpeedCase> MeasureSpeed(
  const LoadedScene& loaded, const SpeedOptions& options, const OnStep& onStep)
{
  std::vector<SpeedCase> cases;
  for (const bool shaded : options.shaded)
  {
    for (const int side : options.sides)
    {
      const std::string what = loaded.name + (shaded ? ", shaded, " : ", ") + std::to_string(side) +
        " x " + std::to_string(side) + ": ";
      const OnStep onStepHere = [&](const std::string& step) { onStep(what + step); };
      Scene scene = loaded.scene;
      scene.look.shading.enabled = shaded;
      scene.size = { side, side };
      const Truth truth = TruthOf(scene, loaded.volume.image, onStepHere);
      const Bench bench = { scene, loaded.volume.image, truth, options, onStepHere };
      SpeedCase measured = { loaded.name, shaded, side, DefaultPoints(bench), {}, {}, {} };
      KeepErrors(bench, measured);
      bench.AddRounds(measured);
      measured.openglRenderer = bench.NewView(MapperKind::Varimarch, scene.render).DeviceName();
      cases.push_back(measured);
    }
  }
  return cases;
}

nlohmann::ordered_json ToJson(const SpeedPoint& point)
{
  nlohmann::ordered_json json = { { "method", point.method },
    { "renderer", NameOf(MapperKindNames(), point.kind) } };
  if (point.options.sampleDistanceMm)
  {
    json["sampleDistanceMm"] = *point.options.sampleDistanceMm;
  }
  else
  {
    json["errorTolerance"] = point.options.errorTolerance;
  }
  json["error255"] = ToJson(point.error);
  if (point.fetchesPerPixel)
  {
    json["fetchesPerPixel"] = *point.fetchesPerPixel;
    json["graphicsBytes"] = *point.graphicsBytes;
  }
  json["median"] = ToJson(point.median);
  for (const FrameCost& cost : point.rounds)
  {
    json["rounds"].push_back(ToJson(cost));
  }
  return json;
}

nlohmann::ordered_json ToJson(const SpeedCase& measured)
{
  nlohmann::ordered_json json = { { "scene", measured.scene }, { "shaded", measured.shaded },
    { "side", measured.side }, { "openglRenderer", measured.openglRenderer } };
  for (const SpeedPoint& point : measured.points)
  {
    json["points"].push_back(ToJson(point));
  }
  for (std::size_t i = 0; i < SpeedTargets().size(); ++i)
  {
    if (const auto times = TimesAsFast(measured, i))
    {
      json["keeping"].push_back(
        { { "target", i }, { "rival", SpeedTargets()[i].rival }, { "point", *measured.keeping[i] },
          { "timesAsFast", *times }, { "rounds", measured.timesAsFast[i] } });
    }
  }
  return json;
}

nlohmann::ordered_json JsonOfTargets()
{
  nlohmann::ordered_json json;
  for (const SpeedTarget& target : SpeedTargets())
  {
    json.push_back(
      { { "against", target.title }, { "rival", target.rival }, { "ours", target.ours },
        { "timesWanted", target.timesWanted }, { "timesAtLeast", target.timesAtLeast } });
  }
  return json;
}

void AddSpeedOptions(CLI::App& command, SpeedOptions& options)
{
  AddBenchSceneOptions(command, options.scenes);
  command.add_option("--sides", options.sides, "Sides of the square images (default 256,512,1024)")
    ->delimiter(',')
    ->check(CLI::Range(1, 4096).description(""))
    ->type_name("PIXELS");
  const auto setShaded = [&options](const std::string& shading)
  {
    options.shaded =
      shading == "both" ? std::vector<bool>{ false, true } : std::vector<bool>{ shading == "on" };
  };
  command
    .add_option_function<std::string>(
      "--shading", setShaded, "Draw with shading, without, or both (default both)")
    ->check(OneOf({ "both", "off", "on" }));
  AddRoundsOption(command, options.rounds);
  AddLongestOption(
    command, options.longestSeconds, "Draw frames that take longer in only one round (default 20)");
}

void RunSpeed(const SpeedOptions& options, BenchResults& results)
{
  results.json.update({ { "rounds", options.rounds }, { "longestSeconds", options.longestSeconds },
    { "targets", JsonOfTargets() } });
  MeasureSceneByScene(options.scenes, results,
    [&](const LoadedScene& scene, const OnStep& onStep)
    {
      for (const SpeedCase& measured : MeasureSpeed(scene, options, onStep))
      {
        results.json["cases"].push_back(ToJson(measured));
      }
    });
}

}

Benchmark SpeedBenchmark()
{
  return MakeBenchmark("speed",
    "Compare times with VTK's mappers, our march without a field and the published one",
    "Examples:\n"
    "  varimarch-bench speed --volumes volumes -o report\n"
    "  varimarch-bench speed --volumes volumes --only bonsai,tooth-soft -o report\n"
    "  varimarch-bench speed Data/Scenes/*.json -o report --sides 256 --shading off",
    AddSpeedOptions, RunSpeed);
}

}
