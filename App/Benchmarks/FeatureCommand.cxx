#include "Commands.h"

#include "CommandLine/OutputFolder.h"
#include "CommandLine/Progress.h"
#include "CommandLine/Results.h"
#include "FeatureReport.h"
#include "Scene/OutputFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace varimarch
{

namespace
{

bool IsWanted(const Feature& feature, const std::vector<std::string>& only)
{
  return only.empty() || std::find(only.begin(), only.end(), feature.name) != only.end();
}

void Write(const FeaturePage& page, const ReportArguments& report)
{
  const std::filesystem::path folder = report.outputFolder;
  const nlohmann::ordered_json results = ToJson(page);
  WriteResults(results, folder / "features.json");
  WriteResults(results, report.jsonPath);
  WriteFileWhole(folder / "features.md", FeatureMarkdown(page));
}

void MeasureFeatures(
  const FeatureArguments& arguments, const Scene& scene, vtkImageData* image, FeaturePage& page)
{
  Progress progress("Measuring features");
  for (const Feature& feature : Features())
  {
    if (IsWanted(feature, arguments.only))
    {
      page.features.push_back(MeasureFeature(feature, scene, image, arguments.rounds,
        [&](const std::string& step) { progress.SetActivity(step); }));
      Write(page, arguments.report);
      SetInterruptNotice(arguments.report.outputFolder, "features up to " + feature.name);
    }
  }
}

}

void RunFeatures(const FeatureArguments& arguments)
{
  const std::filesystem::path folder = OutputFolder(arguments.report.outputFolder);
  const auto [scene, volume] = LoadScene(arguments.scene, arguments.input);
  FeaturePage page = { arguments.report.commandText, ThisMachine(), arguments.rounds, scene.size,
    std::filesystem::path(arguments.input).filename().string(), {} };
  SetInterruptNotice(folder, "nothing yet");
  MeasureFeatures(arguments, scene, volume.image, page);
  std::cout << FeatureMarkdown(page);
}

}
