#include "Commands.h"

#include "CommandLine/OutputFolder.h"
#include "CommandLine/Progress.h"
#include "CommandLine/Results.h"
#include "Machine.h"
#include "Scene/OutputFile.h"
#include "ShadowPromises.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>

namespace varimarch
{

namespace
{

/// The measurements of `varimarch-bench shadows`, and how they were made.
struct ShadowPage
{
  std::string commandText;
  Machine machine;
  ShadowOptions options;
  std::vector<ShadowCase> cases;
  std::vector<ShadowPromises> promises; ///< in the order of the cases
};

constexpr std::array<ShadowMotion, ShadowMotions> Motions = { ShadowMotion::Still,
  ShadowMotion::Turning, ShadowMotion::LightDragged };
constexpr std::array<const char*, ShadowMotions> MotionNames = { "still", "turning",
  "light dragged" };

std::string Row(const ShadowCase& measured)
{
  std::string row = "| " + measured.scene + " |";
  for (int motion = 0; motion < ShadowMotions; ++motion)
  {
    row += " " + Fixed(measured.withoutMs[motion], 1) + " | " + Fixed(measured.withMs[motion], 1) +
      " | " + Fixed(measured.factor[motion], 2) + " |";
  }
  return row + " " + Fixed(measured.firstMs, 0) + " | " + Fixed(measured.error.rootMeanSquare, 2) +
    " | " + Fixed(measured.error.percentile999, 2) + " | " + Fixed(measured.error.largest, 1) +
    " |\n";
}

std::string Markdown(const ShadowPage& page)
{
  const std::string side = std::to_string(page.options.side);
  std::string text = "# Cost of shadows\n\n" + TextOf(page.machine) + ". Images of " + side +
    " x " + side + ", error tolerance " + Fixed(255.0 * page.options.errorTolerance, 2) +
    " of 255, one light fixed in the world, medians of " + std::to_string(page.options.rounds) +
    " alternating rounds. Made by\n\n    " + page.commandText +
    "\n\nTimes without and with shadows [ms] and their factor; the first frame with shadows [ms]; "
    "and its errors [1/255] against rays with samples " +
    Fixed(FineDistanceVoxels(page.options.errorTolerance), 3) +
    " of a voxel apart.\n\n"
    "| scene | still | with | factor | turning | with | factor | light dragged | with | factor "
    "| first | RMSE | 99.9 % | largest |\n"
    "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
  for (const ShadowCase& measured : page.cases)
  {
    text += Row(measured);
  }
  text += "\nGeometric means of the factors:";
  for (int motion = 0; motion < ShadowMotions; ++motion)
  {
    text += std::string(motion > 0 ? ", " : " ") + MotionNames[motion] + " " +
      Fixed(MeanFactor(page.cases, Motions[motion]), 2);
  }
  return text + ".\n" + MarkdownOf(page.promises, page.options);
}

nlohmann::ordered_json ToJson(const ImageError& error)
{
  return { { "rootMeanSquare", error.rootMeanSquare }, { "percentile999", error.percentile999 },
    { "largest", error.largest } };
}

nlohmann::ordered_json ToJson(const std::vector<ShadowPromise>& promises)
{
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const ShadowPromise& promise : promises)
  {
    json.push_back({ { "view", promise.view }, { "errorTolerance", promise.errorTolerance },
      { "error", ToJson(promise.error) } });
  }
  return json;
}

nlohmann::ordered_json ToJson(const ShadowPage& page)
{
  nlohmann::ordered_json json = { { "command", page.commandText },
    { "machine", ToJson(page.machine) }, { "side", page.options.side },
    { "errorTolerance", page.options.errorTolerance } };
  for (std::size_t i = 0; i < page.cases.size(); ++i)
  {
    const ShadowCase& measured = page.cases[i];
    json["scenes"].push_back({ { "scene", measured.scene }, { "withoutMs", measured.withoutMs },
      { "withMs", measured.withMs }, { "factor", measured.factor }, { "firstMs", measured.firstMs },
      { "error", ToJson(measured.error) }, { "promises", ToJson(page.promises[i].promises) } });
  }
  return json;
}

}

void RunShadows(const ShadowArguments& arguments)
{
  ShadowPage page = { arguments.report.commandText, ThisMachine(), arguments.options, {}, {} };
  const SpeedScenes loaded = LoadBenchScenes(arguments.scenes);
  const std::filesystem::path folder = OutputFolder(arguments.report.outputFolder);
  for (const LoadedScene& scene : loaded.scenes)
  {
    SetInterruptNotice(folder,
      std::to_string(page.cases.size()) + " of " + std::to_string(loaded.scenes.size()) +
        " scenes");
    Progress progress("Measuring " + scene.name);
    const OnStep onStep = [&](const std::string& step) { progress.SetActivity(step); };
    page.cases.push_back(MeasureShadows(scene, page.options, onStep));
    page.promises.push_back({ scene.name, MeasureShadowPromises(scene, page.options, onStep) });
    WriteResults(ToJson(page), folder / "shadows.json");
    WriteResults(ToJson(page), arguments.report.jsonPath);
    WriteFileWhole(folder / "shadows.md", Markdown(page));
  }
  std::cout << Markdown(page);
}

}
