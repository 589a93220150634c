#include "Commands.h"

#include "Comparison.h"
#include "ComparisonReport.h"
#include "Options.h"
#include "OutputFolder.h"
#include "Progress.h"
#include "Results.h"
#include "Scene/ComparisonSheet.h"
#include "Scene/DifferencePicture.h"
#include "Scene/ImageFiles.h"
#include "Scene/OutputFile.h"
#include "Scene/SceneNames.h"

#include <filesystem>
#include <iostream>
#include <memory>

namespace varimarch
{

namespace
{

// The pictures of all renderers, their differences from the truth, and all of it on one sheet.
void WritePictures(
  const Comparison& comparison, const Scene& scene, const std::filesystem::path& folder)
{
  const auto truth = BytesOver(comparison.truth.picture, scene.background);
  WritePng(truth, folder / "reference.png");
  std::vector<SheetColumn> columns = { { "truth", "adaptive integral in double precision", truth,
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

struct CompareCommand
{
  std::string commandText;
  SceneOptions sceneOptions;
  std::string outputFolder;
  int rounds = 5;
  std::string jsonPath;

  void Run() const
  {
    const std::filesystem::path folder = OutputFolder(this->outputFolder);
    const auto [scene, volume] = this->sceneOptions.Load();
    auto progress = std::make_unique<Progress>("Integrating the reference");
    const Comparison comparison = Compare(scene, volume.image, this->rounds,
      [&](const std::string& step) { progress->SetActivity(step); });
    progress->SetActivity("Writing " + this->outputFolder);
    WritePictures(comparison, scene, folder);
    WriteFileWhole(folder / "compare.csv", TableCsv(comparison));
    WriteFileWhole(folder / "compare.md", TableMarkdown(comparison, this->commandText));

    nlohmann::ordered_json results = ResultsOf(this->commandText, volume);
    results["look"] = scene.look.name;
    results["size"] = scene.size;
    results.update(ToJson(comparison));
    WriteResults(results, folder / "compare.json");
    WriteResults(results, this->jsonPath);
    progress.reset();
    std::cout << TableText(comparison) << "Pictures and tables: " << this->outputFolder << "\n";
  }
};

}

void AddCompareCommand(CLI::App& program, const std::string& commandText)
{
  const auto command = std::make_shared<CompareCommand>();
  command->commandText = commandText;
  CLI::App* app = program.add_subcommand(
    "compare", "Draw with our mapper and VTK's, and tell the time and the error of each");
  app->footer(
    "Writes a PNG of each renderer and of its difference from the truth,\n"
    "side-by-side.png, and compare.csv, compare.json and compare.md.\n"
    "Examples:\n"
    "  varimarch compare head.nii.gz -o comparison\n"
    "  varimarch compare dicom-folder -o comparison --preset ct-bone --rounds 9\n"
    "  varimarch compare procedural:torso -o comparison --size 256x256 --sample-distance 1");
  command->sceneOptions.AddTo(*app);
  app->add_option("-o,--output", command->outputFolder, "The folder for pictures and tables")
    ->type_name("FOLDER")
    ->required();
  app->add_option("--rounds", command->rounds, "Times to draw with each (default 5)")
    ->check(CLI::Range(1, 10000).description(""))
    ->type_name("N");
  AddJsonOption(*app, command->jsonPath);
  app->callback([command] { command->Run(); });
}

}
