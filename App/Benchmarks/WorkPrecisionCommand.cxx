#include "Commands.h"

#include "CommandLine/OutputFolder.h"
#include "CommandLine/Progress.h"
#include "CommandLine/Results.h"
#include "CommandLine/VtkMessages.h"
#include "LogLogPlot.h"
#include "Scene/ImageFiles.h"
#include "Scene/OutputFile.h"
#include "ToleranceReport.h"
#include "WorkPrecisionMarkdown.h"
#include "WorkPrecisionReport.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

namespace varimarch
{

namespace
{

// A unique name for a scene, made from its input and usable as a file name.
std::string SceneName(const std::string& input, const std::vector<WorkPrecision>& others)
{
  std::string name = std::filesystem::path(input).stem().string();
  std::replace_if(
    name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c) && c != '-'; }, '-');
  const auto taken = [&](const std::string& candidate)
  {
    return std::any_of(others.begin(), others.end(),
      [&](const WorkPrecision& other) { return other.name == candidate; });
  };
  std::string unique = name;
  for (int number = 2; taken(unique); ++number)
  {
    unique = name + "-" + std::to_string(number);
  }
  return unique;
}

std::string TextOf(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
}

// Writes a scene's plots, and returns them as SVG texts.
std::vector<std::string> WrittenPlots(
  const WorkPrecision& scene, const std::filesystem::path& folder)
{
  const std::filesystem::path time = folder / PlotStem(scene);
  const std::filesystem::path fetches = folder / (scene.name + "-readings");
  std::vector<std::string> svgs;
  for (const auto& [plot, stem] :
    { std::pair(TimePlot(scene), time), { FetchPlot(scene), fetches } })
  {
    if (WritePlot(plot, stem))
    {
      svgs.push_back(TextOf(stem.string() + ".svg"));
    }
  }
  return svgs;
}

// Writes the image of each method at about one sample per voxel.
void WritePictures(const WorkPrecision& scene, const std::filesystem::path& folder)
{
  for (const WorkCurve& curve : scene.curves)
  {
    const std::string name = scene.name + "-" + curve.method.name + ".png";
    WritePng(BytesOver(curve.picture, scene.scene.background), (folder / name).string());
  }
}

void Write(const std::vector<WorkPrecision>& scenes, const WorkPrecisionPage& page,
  const ReportArguments& report)
{
  const std::filesystem::path folder = report.outputFolder;
  nlohmann::ordered_json results = { { "command", report.commandText },
    { "machine", ToJson(page.machine) } };
  for (const WorkPrecision& scene : scenes)
  {
    nlohmann::ordered_json json = ResultsOf(report.commandText, scene.volume);
    json.erase("command");
    json.update(ToJson(scene));
    results["scenes"].push_back(json);
  }
  WriteResults(results, folder / "work-precision.json");
  WriteResults(results, report.jsonPath);
  WriteFileWhole(folder / "work-precision.csv", TableCsv(scenes));
  WriteFileWhole(folder / "work-precision.md", WorkPrecisionMarkdown(scenes, page));
  WriteFileWhole(folder / "work-precision.html", WorkPrecisionHtml(scenes, page));
}

}

void RunWorkPrecision(const WorkPrecisionArguments& arguments)
{
  const std::filesystem::path folder = OutputFolder(arguments.report.outputFolder);
  WorkPrecisionPage page = { arguments.report.commandText, ThisMachine(), {} };
  std::vector<WorkPrecision> scenes;
  for (const std::string& input : arguments.inputs)
  {
    SetInterruptNotice(folder,
      std::to_string(scenes.size()) + " of " + std::to_string(arguments.inputs.size()) + " scenes");
    const auto [scene, volume] = LoadScene(arguments.scene, input);
    Progress progress("Measuring " + input);
    scenes.push_back(MeasureRuns(SceneName(input, scenes), scene, volume,
      WorkPrecisionRuns(scene, volume.image, arguments.methods), arguments.options,
      [&](const std::string& step) { progress.SetActivity(step); }));
    page.plotSvgs.push_back(WrittenPlots(scenes.back(), folder));
    WritePictures(scenes.back(), folder);
    ThrowIfVtkReportedError();
    Write(scenes, page, arguments.report);
  }
  std::cout << TableText(scenes) << ToleranceText(scenes)
            << "Report: " << (folder / "work-precision.html").string() << "\n";
}

}
