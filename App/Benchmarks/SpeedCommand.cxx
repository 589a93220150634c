#include "Commands.h"

#include "CommandLine/OutputFolder.h"
#include "CommandLine/Progress.h"
#include "CommandLine/Results.h"
#include "CommandLine/UsageError.h"
#include "LogLogPlot.h"
#include "Scene/OutputFile.h"
#include "SpeedReport.h"
#include "SpeedSummary.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>

namespace varimarch
{

SpeedScenes LoadBenchScenes(const BenchSceneArguments& arguments)
{
  SpeedScenes loaded;
  if (!arguments.volumes.empty())
  {
    loaded = LoadSpeedScenes(arguments.volumes, arguments.only);
  }
  for (const std::string& input : arguments.inputs)
  {
    const auto [scene, volume] = LoadScene(SceneArguments(), input);
    loaded.scenes.push_back({ std::filesystem::path(input).stem().string(), scene, volume });
  }
  if (loaded.scenes.empty())
  {
    throw UsageError("SCENES or --volumes is required");
  }
  return loaded;
}

namespace
{

void Write(const SpeedPage& page, const ReportArguments& report)
{
  const std::filesystem::path folder = report.outputFolder;
  const nlohmann::ordered_json results = ToJson(page);
  WriteResults(results, folder / "speed.json");
  WriteResults(results, report.jsonPath);
  WriteFileWhole(folder / "speed.md", SpeedMarkdown(page));
  WritePlot(SpeedPlot(page.cases), folder / "speed");
}

}

void RunSpeed(const SpeedArguments& arguments)
{
  SpeedPage page = { arguments.report.commandText, ThisMachine(), arguments.options, {}, {} };
  const SpeedScenes loaded = LoadBenchScenes(arguments.scenes);
  const std::filesystem::path folder = OutputFolder(arguments.report.outputFolder);
  page.missing = loaded.missing;
  for (std::size_t i = 0; i < loaded.scenes.size(); ++i)
  {
    const LoadedScene& scene = loaded.scenes[i];
    SetInterruptNotice(
      folder, std::to_string(i) + " of " + std::to_string(loaded.scenes.size()) + " scenes");
    Progress progress("Measuring " + scene.name);
    const std::vector<SpeedCase> cases = MeasureSpeed(
      scene, page.options, [&](const std::string& step) { progress.SetActivity(step); });
    page.cases.insert(page.cases.end(), cases.begin(), cases.end());
    Write(page, arguments.report);
  }
  std::cout << SpeedMarkdown(page);
}

}
