#include "Commands.h"

#include "CommandLine/OutputFolder.h"
#include "CommandLine/Progress.h"
#include "CommandLine/Results.h"
#include "LightMethodsReport.h"
#include "Scene/OutputFile.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>

namespace varimarch
{

void RunLightMethods(const LightCostArguments& arguments)
{
  LightMethodsPage page = { arguments.report.commandText, ThisMachine(), arguments.options, {} };
  const SpeedScenes loaded = LoadBenchScenes(arguments.scenes);
  const std::filesystem::path folder = OutputFolder(arguments.report.outputFolder);
  for (const LoadedScene& scene : loaded.scenes)
  {
    SetInterruptNotice(folder,
      std::to_string(page.cases.size()) + " of " + std::to_string(loaded.scenes.size()) +
        " scenes");
    Progress progress("Measuring " + scene.name);
    page.cases.push_back(MeasureLightMethods(
      scene, page.options, [&](const std::string& step) { progress.SetActivity(step); }));
    WriteResults(ToJson(page), folder / "light-methods.json");
    WriteResults(ToJson(page), arguments.report.jsonPath);
    WriteFileWhole(folder / "light-methods.csv", CsvOf(page));
    WriteFileWhole(folder / "light-methods.md", MarkdownOf(page));
  }
  std::cout << MarkdownOf(page);
}

}
