#include "Commands.h"

#include "Comparison.h"
#include "ComparisonReport.h"
#include "Messages.h"
#include "OutputFolder.h"
#include "Progress.h"
#include "Results.h"
#include "Scene/Files/OutputFile.h"
#include "Scene/Images/DifferencePicture.h"
#include "Scene/Images/ImageFiles.h"
#include "Scene/Json/SceneNames.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>
#include <memory>

namespace varimarch
{

namespace
{

// Writes each renderer's image, its difference from the truth, and a sheet with all of them.
void WritePictures(
  const Comparison& comparison, const Scene& scene, const std::filesystem::path& folder)
{
  const auto truth = BytesOver(comparison.truth.picture, scene.background);
  WritePng(truth, folder / "reference.png");
  std::vector<SheetColumn> columns = { { "truth", ShortlyDescribed(comparison.truth), truth,
    nullptr } };
  for (const Measurement& measurement : comparison.measurements)
  {
    const std::string& name = NameOf(MapperKindNames(), measurement.kind);
    const auto picture = BytesOver(measurement.picture, scene.background);
    const auto difference = DifferencePicture(measurement.picture, comparison.truth.picture);
    WritePng(picture, folder / (name + ".png"));
    WritePng(WithDifferenceScale(difference), folder / ("difference-" + name + ".png"));
    columns.push_back({ ClassName(measurement.kind),
      Fixed(measurement.medianMs, 1) + " ms, error " +
        Fixed(measurement.error.light.rootMeanSquare, 2) + " of 255 (RMS)",
      picture, difference });
  }
  WritePng(ComparisonSheet(columns), folder / "side-by-side.png");
}

// Writes the images, the tables and the results.
void WriteComparison(const Comparison& comparison, const Scene& scene, const LoadedVolume& volume,
  const CompareArguments& arguments)
{
  const std::filesystem::path folder = arguments.outputFolder;
  WritePictures(comparison, scene, folder);
  WriteFileWhole(folder / "compare.csv", TableCsv(comparison));
  WriteFileWhole(folder / "compare.md", TableMarkdown(comparison, arguments.commandText));

  nlohmann::ordered_json results = ResultsOf(arguments.commandText, volume);
  results["look"] = scene.look.name;
  results["size"] = scene.size;
  results.update(ToJson(comparison));
  WriteResults(results, folder / "compare.json");
  WriteResults(results, arguments.jsonPath);
}

}

void RunCompare(const CompareArguments& arguments)
{
  OutputFolder(arguments.outputFolder);
  auto [scene, volume] = LoadScene(arguments.scene);
  if (scene.labels)
  {
    PrintMessage("warning: the labels are not drawn, because the reference has none");
    scene.labels.reset();
  }
  if (!scene.overlays.empty())
  {
    PrintMessage("warning: only the first volume is drawn, because the reference has no other");
    scene.overlays.clear();
  }
  auto progress = std::make_unique<Progress>("Integrating the reference");
  const Comparison comparison = Compare(scene, volume.image, arguments.rounds, arguments.paths,
    [&](const std::string& step) { progress->SetActivity(step); });
  progress->SetActivity("Writing " + arguments.outputFolder);
  WriteComparison(comparison, scene, volume, arguments);
  progress.reset();
  std::cout << TableText(comparison) << "Images and tables: " << arguments.outputFolder << "\n";
}

}
