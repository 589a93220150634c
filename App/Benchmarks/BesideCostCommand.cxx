#include "BesideCost.h"
#include "Commands.h"

#include "CommandLine/Results.h"
#include "LightRun.h"

#include <nlohmann/json.hpp>

namespace varimarch
{

namespace
{

/// The measurements of all scenes.
struct BesidePage
{
  LightRun run;
  std::vector<BesideCosts> scenes;
};

std::string Markdown(const BesidePage& page)
{
  const std::string side = std::to_string(page.run.options.side);
  std::string text = "# Cost of shadows beside a volume\n\n" + TextOf(page.run.machine) +
    ". Images of " + side + " x " + side + ", error tolerance " +
    Fixed(255.0 * page.run.options.errorTolerance, 2) +
    " of 255, one light fixed in the world, whose shadows on the volume itself all images have, "
    "except the first of two volumes that overlap. Medians over images drawn in turn with and "
    "without it, rounds: " +
    std::to_string(page.run.options.rounds) + ". Made by\n\n    " + page.run.commandText +
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
  nlohmann::ordered_json json = ToJson(page.run);
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
  BesidePage page{ LightRunOf(arguments), {} };
  SceneBySceneBench bench;
  bench.name = "shadows-beside";
  bench.measure = [&](const LoadedScene& scene, const OnStep& onStep)
  { page.scenes.push_back(MeasureBesideCosts(scene, page.run.options, onStep)); };
  bench.json = [&] { return ToJson(page); };
  bench.markdown = [&] { return Markdown(page); };
  RunSceneByScene(arguments, bench);
}

}
