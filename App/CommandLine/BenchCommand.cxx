#include "Commands.h"

#include "FeatureCommand.h"
#include "Options.h"
#include "OutputFolder.h"
#include "Progress.h"
#include "PublishedReport.h"
#include "Results.h"
#include "Scene/ImageFiles.h"
#include "Scene/OutputFile.h"
#include "SpeedCommand.h"
#include "ToleranceReport.h"
#include "Validators.h"
#include "VtkMessages.h"
#include "WorkPrecisionMarkdown.h"
#include "WorkPrecisionReport.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>

namespace varimarch
{

namespace
{

// A scene's input as part of a file name, not one of those that are taken.
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

// Writes a plot as PNG and SVG, and returns the SVG's text.
std::string WrittenPlot(const LogLogPlot& plot, const std::string& stem)
{
  WritePng(DrawPlot(plot), stem + ".png");
  WritePlotSvg(plot, stem + ".svg");
  std::ifstream file(stem + ".svg", std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
}

std::vector<std::string> WrittenPlots(
  const WorkPrecision& scene, const std::filesystem::path& folder)
{
  std::vector<std::string> svgs = { WrittenPlot(
    TimePlot(scene), (folder / PlotStem(scene)).string()) };
  const LogLogPlot fetches = FetchPlot(scene);
  if (!fetches.curves.empty())
  {
    svgs.push_back(WrittenPlot(fetches, (folder / (scene.name + "-readings")).string()));
  }
  return svgs;
}

struct WorkPrecisionCommand
{
  std::string commandText;
  SceneOptions sceneOptions;
  std::vector<std::string> inputs;
  std::vector<std::string> methods;
  MeasuringOptions options;
  std::string outputFolder;
  std::string jsonPath;

  void Run() const
  {
    const std::filesystem::path folder = OutputFolder(this->outputFolder);
    WorkPrecisionPage page = { this->commandText, ThisMachine(), {} };
    std::vector<WorkPrecision> scenes;
    for (const std::string& input : this->inputs)
    {
      SetInterruptNotice(folder,
        std::to_string(scenes.size()) + " of " + std::to_string(this->inputs.size()) + " scenes");
      const auto [scene, volume] = this->sceneOptions.Load(input);
      Progress progress("Measuring " + input);
      scenes.push_back(MeasureRuns(SceneName(input, scenes), scene, volume,
        WorkPrecisionRuns(scene, volume.image, this->methods), this->options,
        [&](const std::string& step) { progress.SetActivity(step); }));
      page.plotSvgs.push_back(WrittenPlots(scenes.back(), folder));
      ThrowIfVtkReportedError();
      this->Write(scenes, page, folder);
    }
    std::cout << TableText(scenes) << ToleranceText(scenes)
              << "Report: " << (folder / "work-precision.html").string() << "\n";
  }

  void Write(const std::vector<WorkPrecision>& scenes, const WorkPrecisionPage& page,
    const std::filesystem::path& folder) const
  {
    nlohmann::ordered_json results = { { "command", this->commandText },
      { "machine", ToJson(page.machine) } };
    for (const WorkPrecision& scene : scenes)
    {
      nlohmann::ordered_json json = ResultsOf(this->commandText, scene.volume);
      json.erase("command");
      json.update(ToJson(scene));
      results["scenes"].push_back(json);
    }
    WriteResults(results, folder / "work-precision.json");
    WriteResults(results, this->jsonPath);
    WriteFileWhole(folder / "work-precision.csv", TableCsv(scenes));
    WriteFileWhole(folder / "work-precision.md", WorkPrecisionMarkdown(scenes, page));
    WriteFileWhole(folder / "work-precision.html", WorkPrecisionHtml(scenes, page));
  }
};

void AddWorkPrecisionCommand(CLI::App& bench, const std::string& commandText)
{
  const auto command = std::make_shared<WorkPrecisionCommand>();
  command->commandText = commandText;
  CLI::App* app = bench.add_subcommand(
    "work-precision", "Error against run time of our mapper's choices and of VTK's mappers");
  app->footer("Writes work-precision.html, which needs no other file, .md, .csv and .json, and "
              "each scene's plots\n"
              "as PNG and SVG, after each scene: stopped, it leaves what it has.\n"
              "Examples:\n"
              "  varimarch bench work-precision head.nii.gz -o report --size 256x256\n"
              "  varimarch bench work-precision Data/Scenes/*.json -o report --rounds 5\n"
              "  varimarch bench work-precision scene.json -o report --methods optical,vtk-gpu");
  app
    ->add_option("SCENES", command->inputs,
      "Scene files (.json), volume files, DICOM folders, or procedural:NAME[:XxYxZ]")
    ->required();
  command->sceneOptions.AddLookAndPictureTo(*app);
  AddOutputOption(*app, command->outputFolder);
  app->add_option("--methods", command->methods, "Only these (default all)")
    ->delimiter(',')
    ->check(NameValidator(BenchMethodNames()));
  AddRoundsOption(*app, command->options.rounds);
  app
    ->add_option("--longest", command->options.longestSeconds,
      "Leave out finer settings when a picture took longer (default 3)")
    ->check(CLI::PositiveNumber.description(""))
    ->type_name("SECONDS");
  AddJsonOption(*app, command->jsonPath);
  app->callback([command] { command->Run(); });
}

struct PublishedCommand
{
  std::string commandText;
  PublishedOptions options;
  std::string outputFolder;
  std::string jsonPath;

  void Run() const
  {
    const std::filesystem::path folder = OutputFolder(this->outputFolder);
    PublishedPage page = { this->commandText, ThisMachine(), {} };
    SetInterruptNotice(folder, "nothing yet");
    {
      Progress progress("Measuring the published scenes");
      MeasurePublished(
        this->options, [&](const std::string& step) { progress.SetActivity(step); },
        [&](const PublishedMeasurements& measured)
        {
          page.measured = measured;
          this->Write(page, folder);
        });
    }
    std::cout << PublishedMarkdown(page);
  }

  void Write(const PublishedPage& page, const std::filesystem::path& folder) const
  {
    WriteFileWhole(folder / "published.md", PublishedMarkdown(page));
    const nlohmann::ordered_json results = ToJson(page);
    WriteResults(results, folder / "published.json");
    WriteResults(results, this->jsonPath);
    SetInterruptNotice(folder,
      std::to_string(page.measured.volumes.size() + page.measured.volt.size()) +
        " scenes of those it was to measure");
  }
};

void AddPublishedCommand(CLI::App& bench, const std::string& commandText)
{
  const auto command = std::make_shared<PublishedCommand>();
  command->commandText = commandText;
  CLI::App* app =
    bench.add_subcommand("published", "The scenes of two papers, with their figures beside ours");
  app->footer(
    "Scenes: Banquero, Ortiz, Rossi 2016, tables 1 and 2, and Volt 2009. Volumes that the folder\n"
    "does not hold are left out, and named.\n"
    "Example:\n"
    "  varimarch bench published --volumes volumes -o published");
  app
    ->add_option("--volumes", command->options.folder,
      "The folder of the papers' volumes (default: the environment's VARIMARCH_VOLUMES)")
    ->envname("VARIMARCH_VOLUMES")
    ->check(CLI::ExistingDirectory.description(""))
    ->type_name("FOLDER")
    ->required();
  AddOutputOption(*app, command->outputFolder);
  app->add_option("--side", command->options.side, "Of the square pictures (default 512)")
    ->check(CLI::Range(1, 4096).description(""))
    ->type_name("PIXELS");
  AddRoundsOption(*app, command->options.rounds);
  AddJsonOption(*app, command->jsonPath);
  app->callback([command] { command->Run(); });
}

}

void AddBenchCommand(CLI::App& program, const std::string& commandText)
{
  CLI::App* bench = program.add_subcommand("bench", "Measure error and run time systematically");
  bench->require_subcommand(1);
  AddWorkPrecisionCommand(*bench, commandText);
  AddPublishedCommand(*bench, commandText);
  AddSpeedCommand(*bench, commandText);
  AddScalingCommand(*bench, commandText);
  AddFeatureCommand(*bench, commandText);
}

}
