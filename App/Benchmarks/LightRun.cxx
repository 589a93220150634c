#include "LightRun.h"

#include "CommandLine/OutputFolder.h"
#include "CommandLine/Progress.h"
#include "CommandLine/Results.h"
#include "Scene/OutputFile.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>

namespace varimarch
{

LightRun LightRunOf(const LightCostArguments& arguments)
{
  return { arguments.report.commandText, ThisMachine(), arguments.options };
}

nlohmann::ordered_json ToJson(const LightRun& run)
{
  return { { "command", run.commandText }, { "machine", ToJson(run.machine) },
    { "side", run.options.side }, { "errorTolerance", run.options.errorTolerance } };
}

void RunSceneByScene(const LightCostArguments& arguments, const SceneBySceneBench& bench)
{
  const SpeedScenes loaded = LoadBenchScenes(arguments.scenes);
  const std::filesystem::path folder = OutputFolder(arguments.report.outputFolder);
  for (std::size_t i = 0; i < loaded.scenes.size(); ++i)
  {
    SetInterruptNotice(
      folder, std::to_string(i) + " of " + std::to_string(loaded.scenes.size()) + " scenes");
    Progress progress("Measuring " + loaded.scenes[i].name);
    bench.measure(loaded.scenes[i], [&](const std::string& step) { progress.SetActivity(step); });
    WriteResults(bench.json(), folder / (bench.name + ".json"));
    WriteResults(bench.json(), arguments.report.jsonPath);
    WriteFileWhole(folder / (bench.name + ".md"), bench.markdown());
    if (bench.csv)
    {
      WriteFileWhole(folder / (bench.name + ".csv"), bench.csv());
    }
  }
  std::cout << bench.markdown();
}

}
