#include "Commands.h"

#include "CommandLine/PictureError.h"
#include "CommandLine/Results.h"
#include "LightPromises.h"
#include "LightRun.h"

#include <nlohmann/json.hpp>

namespace varimarch
{

namespace
{

/// The measurements of a feature.
struct LightCostPage
{
  LightRun run;
  std::vector<LightCost> cases;
  std::vector<LightPromises> promises; ///< in the order of the cases
};

constexpr std::array<LightMotion, LightMotions> Motions = { LightMotion::Still,
  LightMotion::Turning, LightMotion::LightDragged };
constexpr std::array<const char*, LightMotions> MotionNames = { "still", "turning", "dragged" };

std::string Row(const LightCost& measured)
{
  std::string row = "| " + measured.scene + " |";
  for (int motion = 0; motion < LightMotions; ++motion)
  {
    row += " " + Fixed(measured.withoutMs[motion], 1) + " | " + Fixed(measured.withMs[motion], 1) +
      " | " + Fixed(measured.factor[motion], 2) + " |";
  }
  return row + " " + Fixed(measured.firstMs, 0) + " | " + Fixed(measured.error.rootMeanSquare, 2) +
    " | " + Fixed(measured.error.percentile999, 2) + " | " + Fixed(measured.error.largest, 1) +
    " |\n";
}

std::string Markdown(const LightCostPage& page)
{
  const std::string side = std::to_string(page.run.options.side);
  const std::string feature = page.run.options.feature.text;
  std::string text = "# Cost of " + feature + "\n\n" + TextOf(page.run.machine) + ". Images of " +
    side + " x " + side + ", error tolerance " + Fixed(255.0 * page.run.options.errorTolerance, 2) +
    " of 255, one light fixed in the world, medians of " + std::to_string(page.run.options.rounds) +
    " alternating rounds. Made by\n\n    " + page.run.commandText + "\n\nTimes without and with " +
    feature + " [ms] and their factor, still, while the camera turns, and while the " +
    page.run.options.feature.dragged +
    " is dragged; the first frame with it [ms]; and its errors [1/255] against rays with samples " +
    Fixed(FineDistanceVoxels(page.run.options.errorTolerance), 3) +
    " of a voxel apart.\n\n"
    "| scene | still | with | factor | turning | with | factor | dragged | with | factor "
    "| first | RMSE | 99.9 % | largest |\n"
    "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
  for (const LightCost& measured : page.cases)
  {
    text += Row(measured);
  }
  text += "\nGeometric means of the factors:";
  for (int motion = 0; motion < LightMotions; ++motion)
  {
    text += std::string(motion > 0 ? ", " : " ") + MotionNames[motion] + " " +
      Fixed(MeanFactor(page.cases, Motions[motion]), 2);
  }
  return text + ".\n" + MarkdownOf(page.promises, page.run.options);
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

nlohmann::ordered_json ToJson(const LightCostPage& page)
{
  nlohmann::ordered_json json = ToJson(page.run);
  for (std::size_t i = 0; i < page.cases.size(); ++i)
  {
    const LightCost& measured = page.cases[i];
    json["scenes"].push_back({ { "scene", measured.scene }, { "withoutMs", measured.withoutMs },
      { "withMs", measured.withMs }, { "factor", measured.factor }, { "firstMs", measured.firstMs },
      { "error", ToJson(measured.error) }, { "promises", ToJson(page.promises[i].promises) } });
  }
  return json;
}

}

void RunLightCost(const LightCostArguments& arguments)
{
  LightCostPage page{ LightRunOf(arguments), {}, {} };
  SceneBySceneBench bench;
  bench.name = arguments.options.feature.name;
  bench.measure = [&](const LoadedScene& scene, const OnStep& onStep)
  {
    page.cases.push_back(MeasureLightCost(scene, page.run.options, onStep));
    page.promises.push_back({ scene.name, MeasureLightPromises(scene, page.run.options, onStep) });
  };
  bench.json = [&] { return ToJson(page); };
  bench.markdown = [&] { return Markdown(page); };
  RunSceneByScene(arguments, bench);
}

}
