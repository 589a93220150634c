#include "BesideCost.h"
#include "Commands.h"

#include "CommandLine/OutputFolder.h"
#include "CommandLine/Progress.h"
#include "CommandLine/Results.h"
#include "Machine.h"
#include "Scene/OutputFile.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>

namespace varimarch
{

namespace
{

/// The measurements, and how they were made.
struct BesidePage
{
  std::string commandText;
  Machine machine;
  LightCostOptions options;
  std::vector<BesideCosts> scenes;
};

std::string Markdown(const BesidePage& page)
{
  const std::string side = std::to_string(page.options.side);
  std::string text = "# Cost of shadows beside a volume\n\n" + TextOf(page.machine) +
    ". Images of " + side + " x " + side + ", error tolerance " +
    Fixed(255.0 * page.options.errorTolerance, 2) +
    " of 255, one light fixed in the world, whose shadows on the volume itself all images have, "
    "except the first of two volumes that overlap. Medians over images drawn in turn with and "
    "without it, rounds: " +
    std::to_string(page.options.rounds) + ". Made by\n\n    " + page.commandText +
    "\n\nTimes of a still image without what the first column says, of one with it, their factor, "
    "and the first image with it [ms]. Where geometry moves, the image without it is that of "
    "geometry at rest.\n\n"
    "| scene | | without | with | factor | first |\n|---|---|---:|---:|---:|---:|\n";
  for (const BesideCosts& scene : page.scenes)
  {
    for (const BesideCost& cost : scene.costs)
    {
      text += "| " + scene.scene + " | " + cost.name + " | " + Fixed(cost.withoutMs, 1) + " | " +
        Fixed(cost.withMs, 1) + " | " + Fixed(cost.factor, 2) + " | " + Fixed(cost.firstMs, 0) +
        " |\n";
    }
  }
  return text;
}

nlohmann::ordered_json ToJson(const BesidePage& page)
{
  nlohmann::ordered_json json = { { "command", page.commandText },
    { "machine", ToJson(page.machine) }, { "side", page.options.side },
    { "errorTolerance", page.options.errorTolerance } };
  for (const BesideCosts& scene : page.scenes)
  {
    nlohmann::ordered_json costs = nlohmann::ordered_json::array();
    for (const BesideCost& cost : scene.costs)
    {
      costs.push_back({ { "name", cost.name }, { "withoutMs", cost.withoutMs },
        { "withMs", cost.withMs }, { "factor", cost.factor }, { "firstMs", cost.firstMs } });
    }
    json["scenes"].push_back({ { "scene", scene.scene }, { "costs", costs } });
  }
  return json;
}

}

void RunBesideCost(const LightCostArguments& arguments)
{
  BesidePage page = { arguments.report.commandText, ThisMachine(), arguments.options, {} };
  const SpeedScenes loaded = LoadBenchScenes(arguments.scenes);
  const std::filesystem::path folder = OutputFolder(arguments.report.outputFolder);
  for (const LoadedScene& scene : loaded.scenes)
  {
    SetInterruptNotice(folder,
      std::to_string(page.scenes.size()) + " of " + std::to_string(loaded.scenes.size()) +
        " scenes");
    Progress progress("Measuring " + scene.name);
    page.scenes.push_back(MeasureBesideCosts(
      scene, page.options, [&](const std::string& step) { progress.SetActivity(step); }));
    WriteResults(ToJson(page), folder / "shadows-beside.json");
    WriteResults(ToJson(page), arguments.report.jsonPath);
    WriteFileWhole(folder / "shadows-beside.md", Markdown(page));
  }
  std::cout << Markdown(page);
}

}
