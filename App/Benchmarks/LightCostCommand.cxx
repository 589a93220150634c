#include "Commands.h"

#include "CommandLine/OutputFolder.h"
#include "CommandLine/PictureError.h"
#include "CommandLine/Progress.h"
#include "CommandLine/Results.h"
#include "LightPromises.h"
#include "Machine.h"
#include "Scene/OutputFile.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>

namespace varimarch
{

namespace
{

/// The measurements of a feature, and how they were made.
struct LightCostPage
{
  std::string commandText;
  Machine machine;
  LightCostOptions options;
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
  const std::string side = std::to_string(page.options.side);
  const std::string feature = page.options.feature.text;
  std::string text = "# Cost of " + feature + "\n\n" + TextOf(page.machine) + ". Images of " +
    side + " x " + side + ", error tolerance " + Fixed(255.0 * page.options.errorTolerance, 2) +
    " of 255, one light fixed in the world, medians of " + std::to_string(page.options.rounds) +
    " alternating rounds. Made by\n\n    " + page.commandText + "\n\nTimes without and with " +
    feature + " [ms] and their factor, still, while the camera turns, and while the " +
    page.options.feature.dragged +
    " is dragged; the first frame with it [ms]; and its errors [1/255] against rays with samples " +
    Fixed(FineDistanceVoxels(page.options.errorTolerance), 3) +
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
  return text + ".\n" + MarkdownOf(page.promises, page.options);
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
  nlohmann::ordered_json json = { { "command", page.commandText },
    { "machine", ToJson(page.machine) }, { "side", page.options.side },
    { "errorTolerance", page.options.errorTolerance } };
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
  LightCostPage page = { arguments.report.commandText, ThisMachine(), arguments.options, {}, {} };
  const SpeedScenes loaded = LoadBenchScenes(arguments.scenes);
  const std::filesystem::path folder = OutputFolder(arguments.report.outputFolder);
  const std::string name = page.options.feature.name;
  for (const LoadedScene& scene : loaded.scenes)
  {
    SetInterruptNotice(folder,
      std::to_string(page.cases.size()) + " of " + std::to_string(loaded.scenes.size()) +
        " scenes");
    Progress progress("Measuring " + scene.name);
    const OnStep onStep = [&](const std::string& step) { progress.SetActivity(step); };
    page.cases.push_back(MeasureLightCost(scene, page.options, onStep));
    page.promises.push_back({ scene.name, MeasureLightPromises(scene, page.options, onStep) });
    WriteResults(ToJson(page), folder / (name + ".json"));
    WriteResults(ToJson(page), arguments.report.jsonPath);
    WriteFileWhole(folder / (name + ".md"), Markdown(page));
  }
  std::cout << Markdown(page);
}

}
