#include "CommandLine/PictureError.h"
#include "CommandLine/ReportedErrors.h"
#include "Core/Quality/ImageError.h"
#include "LightScenes.h"
#include "Scene/Images/OffscreenView.h"
#include "Scene/Median.h"
#include "Scene/Model/SceneLights.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace varimarch
{

namespace
{

/// The change between the frames of a measurement.
enum class LightMotion
{
  Still,
  Turning,      ///< the camera turns by a degree for each frame
  LightDragged, ///< the light turns by two degrees, and occlusion weakens, for each frame
};

constexpr int LightMotions = 3;

/// The cost of a feature in a scene with one light, from the upper right of its camera's first
/// position. Times are medians of all rounds.
struct LightCost
{
  double firstMs = 0.0; ///< the first frame with it, which searches for its steps
  std::array<double, LightMotions> withoutMs = {};
  std::array<double, LightMotions> withMs = {};
  std::array<double, LightMotions> factor = {}; ///< median of the factors of the rounds
  ImageError error = {}; ///< error of the first frame with it, against its fine image
};

/// How well an error tolerance is kept in one view of a scene with the feature.
struct LightPromise
{
  int view; ///< camera turned by this part of a circle from the first view, from 0 on
  double errorTolerance;
  ImageError error = {}; ///< against the fine image of the view
};

constexpr int FramesOfMotion = 9;

/// A view, with or without the feature, and what is measured in it.
struct MeasuredView
{
  OffscreenView view;
  Lighting lighting;
  double firstMs;

  MeasuredView(const Scene& scene, vtkImageData* image)
    : view(scene, image, MapperKind::Varimarch)
    , lighting(LightingOf(scene))
    , firstMs(1000.0 * this->view.Render())
  {
  }

  double MedianMs(LightMotion motion)
  {
    std::vector<double> times;
    for (int frame = 0; frame < FramesOfMotion; ++frame)
    {
      this->Move(motion);
      times.push_back(1000.0 * this->view.Render());
    }
    return Median(times);
  }

private:
  void Move(LightMotion motion)
  {
    if (motion == LightMotion::Turning)
    {
      this->view.Pipeline().Renderer()->GetActiveCamera()->Azimuth(1.0);
      this->view.Pipeline().Renderer()->ResetCameraClippingRange();
    }
    if (motion == LightMotion::LightDragged)
    {
      this->lighting.lights = { Turned(this->lighting.lights.front(), 2.0) };
      this->lighting.occlusion.strength *= 0.98;
      this->view.Pipeline().SetLighting(this->lighting);
    }
  }
};

// The times of each round, one list for each motion.
struct Rounds
{
  std::array<std::vector<double>, LightMotions> without;
  std::array<std::vector<double>, LightMotions> with;
  std::array<std::vector<double>, LightMotions> factor;

  // A slow moment of the machine affects both alike.
  void Add(int round, MeasuredView& plain, MeasuredView& featured)
  {
    for (int motion = 0; motion < LightMotions; ++motion)
    {
      const auto drawPlain = [&]
      { this->without[motion].push_back(plain.MedianMs(LightMotion(motion))); };
      const auto drawWith = [&]
      { this->with[motion].push_back(featured.MedianMs(LightMotion(motion))); };
      if (round % 2 == 0)
      {
        drawPlain();
      }
      drawWith();
      if (round % 2 == 1)
      {
        drawPlain();
      }
      this->factor[motion].push_back(this->with[motion].back() / this->without[motion].back());
    }
  }
};

ImageError ErrorAgainstReference(const Scene& scene, vtkImageData* image)
{
  OffscreenView drawn(scene, image, MapperKind::Varimarch);
  OffscreenView exact(FineScene(scene, scene.render.errorTolerance), image, MapperKind::Varimarch);
  const std::vector<float> pixels = PixelsOf(drawn);
  return CompareImages(pixels.data(), PixelsOf(exact).data(), pixels.size() / 4);
}

// Draws frames with and without the feature, alternately. The error is that against an image of the
// same mapper without a lattice of light, with samples FineDistanceVoxels apart.
LightCost MeasureLightCost(
  const LoadedScene& loaded, const LightCostOptions& options, const OnStep& onStep)
{
  const Scene plain = LitScene(loaded, options);
  const Scene featured = WithFeature(plain, options.feature);
  LightCost measured;
  Rounds rounds;
  std::vector<double> firstMs;
  for (int round = 0; round < options.rounds; ++round)
  {
    onStep("times, round " + std::to_string(round + 1));
    MeasuredView without(plain, loaded.volume.image);
    MeasuredView with(featured, loaded.volume.image);
    firstMs.push_back(with.firstMs);
    rounds.Add(round, without, with);
  }
  measured.firstMs = Median(firstMs);
  for (int motion = 0; motion < LightMotions; ++motion)
  {
    measured.withoutMs[motion] = Median(rounds.without[motion]);
    measured.withMs[motion] = Median(rounds.with[motion]);
    measured.factor[motion] = Median(rounds.factor[motion]);
  }
  onStep("error");
  measured.error = ErrorAgainstReference(featured, loaded.volume.image);
  ThrowIfVtkReportedError();
  return measured;
}

// The scene from another side.
Scene ViewOf(Scene scene, int view, int views)
{
  scene.camera.azimuthDegrees =
    std::remainder(scene.camera.azimuthDegrees + 360.0 * view / views, 360.0);
  return scene;
}

double SmallestOf(const std::vector<double>& tolerances)
{
  return *std::min_element(tolerances.begin(), tolerances.end());
}

std::vector<float> ImageOf(const Scene& scene, vtkImageData* image)
{
  OffscreenView view(scene, image, MapperKind::Varimarch);
  return PixelsOf(view);
}

// Draws a scene from several sides, all in the same light, with each of the tolerances. Images have
// half the side, since the fine ones take long.
std::vector<LightPromise> MeasureLightPromises(
  const LoadedScene& loaded, const LightCostOptions& options, const OnStep& onStep)
{
  Scene lit = WithFeature(LitScene(loaded, options), options.feature);
  lit.size = { std::max(options.side / 2, 1), std::max(options.side / 2, 1) };
  std::vector<LightPromise> promises;
  for (int view = 0; view < options.views; ++view)
  {
    Scene scene = ViewOf(lit, view, options.views);
    onStep("errors, view " + std::to_string(view + 1));
    const std::vector<float> truth =
      ImageOf(FineScene(scene, SmallestOf(options.tolerances)), loaded.volume.image);
    for (const double errorTolerance : options.tolerances)
    {
      scene.render.errorTolerance = errorTolerance;
      const std::vector<float> drawn = ImageOf(scene, loaded.volume.image);
      promises.push_back(
        { view, errorTolerance, CompareImages(drawn.data(), truth.data(), truth.size() / 4) });
    }
  }
  ThrowIfVtkReportedError();
  return promises;
}

nlohmann::ordered_json ToJson(const std::vector<LightPromise>& promises)
{
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const LightPromise& promise : promises)
  {
    json.push_back({ { "view", promise.view }, { "errorTolerance", promise.errorTolerance },
      { "error", ToJson(promise.error) } });
  }
  return json;
}

void AddLightCostOptions(CLI::App& command, LightCostOptions& options)
{
  AddLightOptions(command, options);
  command
    .add_option("--tolerances", options.tolerances,
      "The tolerances whose errors are measured (default 1/16, 1/32, 1/64, 1/128, 1/255)")
    ->delimiter(',')
    ->check(CLI::Range(1e-4, 1.0).description(""))
    ->type_name("ERRORS");
  command
    .add_option("--views", options.views,
      "The number of views of each scene in which they are measured (default 4)")
    ->check(CLI::Range(1, 360).description(""))
    ->type_name("N");
}

void RunLightCost(const LightCostOptions& options, BenchResults& results)
{
  AddLightConditions(options, results);
  results.json.update({ { "feature", options.feature.text }, { "dragged", options.feature.dragged },
    { "views", options.views }, { "tolerances", options.tolerances },
    { "fineVoxelsOfViews", FineDistanceVoxels(SmallestOf(options.tolerances)) } });
  MeasureSceneByScene(options.scenes, results,
    [&](const LoadedScene& scene, const OnStep& onStep)
    {
      const LightCost measured = MeasureLightCost(scene, options, onStep);
      const auto promises = MeasureLightPromises(scene, options, onStep);
      results.json["scenes"].push_back({ { "scene", scene.name },
        { "withoutMs", measured.withoutMs }, { "withMs", measured.withMs },
        { "factor", measured.factor }, { "firstMs", measured.firstMs },
        { "error", ToJson(measured.error) }, { "promises", ToJson(promises) } });
    });
}

}

std::vector<Benchmark> LightCostBenchmarks()
{
  std::vector<Benchmark> benchmarks;
  for (const LightFeature& feature : LightFeatures())
  {
    const std::string command = std::string("  varimarch-bench ") + feature.name;
    LightCostOptions defaults;
    defaults.feature = feature;
    benchmarks.push_back(MakeBenchmark(feature.name,
      std::string("Measure the cost of ") + feature.text + ": still, turning and dragged",
      "Examples:\n" + command + " --volumes volumes -o report\n" + command +
        " head.nii.gz -o report --side 256",
      AddLightCostOptions, RunLightCost, defaults));
  }
  return benchmarks;
}

}
