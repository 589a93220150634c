#include "Commands.h"

#include "CommandLine/OutputFolder.h"
#include "CommandLine/Progress.h"
#include "CommandLine/Results.h"
#include "LogLogPlot.h"
#include "ScalingReport.h"
#include "Scene/OutputFile.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>

namespace varimarch
{

namespace
{

void Write(const ScalingPage& page, const ReportArguments& report)
{
  const std::filesystem::path folder = report.outputFolder;
  const nlohmann::ordered_json results = ToJson(page);
  WriteResults(results, folder / "scaling.json");
  WriteResults(results, report.jsonPath);
  WriteFileWhole(folder / "scaling.md", ScalingMarkdown(page));
  WritePlot(ScalingPlot(page.curves), folder / "scaling");
}

// Adds all curves of one procedural volume, and writes the page after each point.
void AddCurves(const std::string& volume, const ScalingArguments& arguments, ScalingPage& page)
{
  const std::vector<ScalingCurve> before = page.curves;
  std::vector<ScalingCurve> curves = { { volume, MapperKind::Varimarch, {}, {} },
    { volume, MapperKind::VtkGpu, {}, {} } };
  for (const int side : arguments.sides)
  {
    const std::string text = std::to_string(side);
    const std::string input = "procedural:" + volume + ":" + text + "x" + text + "x" + text;
    const auto [scene, loaded] = LoadScene(arguments.scene, input);
    page.size = scene.size;
    Progress progress("Measuring " + input);
    AddScalingPoints(
      { input, scene, loaded }, side, arguments.rounds,
      [&](const std::string& step) { progress.SetActivity(input + ": " + step); }, curves);
    page.curves = before;
    page.curves.insert(page.curves.end(), curves.begin(), curves.end());
    Write(page, arguments.report);
    SetInterruptNotice(arguments.report.outputFolder, "volumes up to " + input);
  }
}

}

void RunScaling(const ScalingArguments& arguments)
{
  SetInterruptNotice(OutputFolder(arguments.report.outputFolder), "nothing yet");
  ScalingPage page = { arguments.report.commandText, ThisMachine(), arguments.rounds, {}, {} };
  for (const std::string volume : { "shells", "torso" })
  {
    AddCurves(volume, arguments, page);
  }
  std::cout << ScalingMarkdown(page);
}

}
