#include "SpeedCommand.h"

#include "Options.h"
#include "OutputFolder.h"
#include "Progress.h"
#include "Results.h"
#include "ScalingReport.h"
#include "Scene/ImageFiles.h"
#include "Scene/OutputFile.h"
#include "SpeedReport.h"
#include "SpeedSummary.h"
#include "Validators.h"

#include <filesystem>
#include <iostream>
#include <memory>

namespace varimarch
{

namespace
{

// As PNG and SVG; nothing where there is nothing to show.
void WritePlot(const LogLogPlot& plot, const std::filesystem::path& stem)
{
  if (!plot.curves.empty())
  {
    WritePng(DrawPlot(plot), stem.string() + ".png");
    WritePlotSvg(plot, stem.string() + ".svg");
  }
}

struct SpeedCommand
{
  std::string commandText;
  std::vector<std::string> inputs;
  std::string volumes;
  std::vector<std::string> only;
  std::string shading = "both";
  SpeedOptions options;
  std::string outputFolder;
  std::string jsonPath;

  SpeedScenes Load() const
  {
    SpeedScenes loaded;
    if (!this->volumes.empty())
    {
      loaded = LoadSpeedScenes(this->volumes, this->only);
    }
    for (const std::string& input : this->inputs)
    {
      const auto [scene, volume] = SceneOptions().Load(input);
      loaded.scenes.push_back({ std::filesystem::path(input).stem().string(), scene, volume });
    }
    if (loaded.scenes.empty())
    {
      throw CLI::RequiredError("SCENES or --volumes");
    }
    return loaded;
  }

  void Run() const
  {
    SpeedPage page = { this->commandText, ThisMachine(), this->options, {}, {} };
    const SpeedScenes loaded = this->Load();
    const std::filesystem::path folder = OutputFolder(this->outputFolder);
    page.missing = loaded.missing;
    page.options.shaded = this->shading == "both" ? std::vector<bool>{ false, true }
                                                  : std::vector<bool>{ this->shading == "on" };
    for (std::size_t i = 0; i < loaded.scenes.size(); ++i)
    {
      const LoadedScene& scene = loaded.scenes[i];
      SetInterruptNotice(
        folder, std::to_string(i) + " of " + std::to_string(loaded.scenes.size()) + " scenes");
      Progress progress("Measuring " + scene.name);
      const std::vector<SpeedCase> cases = MeasureSpeed(
        scene, page.options, [&](const std::string& step) { progress.SetActivity(step); });
      page.cases.insert(page.cases.end(), cases.begin(), cases.end());
      this->Write(page, folder);
    }
    std::cout << SpeedMarkdown(page);
  }

  void Write(const SpeedPage& page, const std::filesystem::path& folder) const
  {
    const nlohmann::ordered_json results = ToJson(page);
    WriteResults(results, folder / "speed.json");
    WriteResults(results, this->jsonPath);
    WriteFileWhole(folder / "speed.md", SpeedMarkdown(page));
    WritePlot(SpeedPlot(page.cases), folder / "speed");
  }
};

struct ScalingCommand
{
  std::string commandText;
  SceneOptions sceneOptions;
  std::vector<int> sides = { 64, 128, 256, 512 };
  int rounds = 3;
  std::string outputFolder;
  std::string jsonPath;

  // Adds all curves of one procedural volume, and writes the page at each point.
  void AddCurves(
    const std::string& volume, const std::filesystem::path& folder, ScalingPage& page) const
  {
    const std::vector<ScalingCurve> before = page.curves;
    std::vector<ScalingCurve> curves = { { volume, MapperKind::Varimarch, {}, {} },
      { volume, MapperKind::VtkGpu, {}, {} } };
    for (const int side : this->sides)
    {
      const std::string text = std::to_string(side);
      const std::string input = "procedural:" + volume + ":" + text + "x" + text + "x" + text;
      const auto [scene, loaded] = this->sceneOptions.Load(input);
      page.size = scene.size;
      Progress progress("Measuring " + input);
      AddScalingPoints(
        { input, scene, loaded }, side, this->rounds,
        [&](const std::string& step) { progress.SetActivity(input + ": " + step); }, curves);
      page.curves = before;
      page.curves.insert(page.curves.end(), curves.begin(), curves.end());
      this->Write(page, folder);
      SetInterruptNotice(folder, "volumes up to " + input);
    }
  }

  void Run() const
  {
    const std::filesystem::path folder = OutputFolder(this->outputFolder);
    ScalingPage page = { this->commandText, ThisMachine(), this->rounds, {}, {} };
    SetInterruptNotice(folder, "nothing yet");
    for (const std::string volume : { "shells", "torso" })
    {
      this->AddCurves(volume, folder, page);
    }
    std::cout << ScalingMarkdown(page);
  }

  void Write(const ScalingPage& page, const std::filesystem::path& folder) const
  {
    const nlohmann::ordered_json results = ToJson(page);
    WriteResults(results, folder / "scaling.json");
    WriteResults(results, this->jsonPath);
    WriteFileWhole(folder / "scaling.md", ScalingMarkdown(page));
    WritePlot(ScalingPlot(page.curves), folder / "scaling");
  }
};

}

void AddSpeedCommand(CLI::App& bench, const std::string& commandText)
{
  const auto command = std::make_shared<SpeedCommand>();
  command->commandText = commandText;
  CLI::App* app = bench.add_subcommand(
    "speed", "Times against VTK's mappers, our march without field and the published one");
  app->footer("Writes speed.md, .json, .png and .svg.\n"
              "Examples:\n"
              "  varimarch bench speed --volumes volumes -o report\n"
              "  varimarch bench speed --volumes volumes --only bonsai,tooth-soft -o report\n"
              "  varimarch bench speed Data/Scenes/*.json -o report --sides 256 --shading off");
  app->add_option("SCENES", command->inputs,
    "Scene files (.json), volume files, DICOM folders, or procedural:NAME[:XxYxZ]");
  app
    ->add_option("--volumes", command->volumes,
      "A folder of well-known volumes, each seen soft, dense and as a thin peak")
    ->check(CLI::ExistingDirectory.description(""))
    ->type_name("FOLDER");
  app->add_option("--only", command->only, "Of these, the scenes whose names start so")
    ->delimiter(',')
    ->type_name("NAMES");
  AddOutputOption(*app, command->outputFolder);
  app
    ->add_option("--sides", command->options.sides, "Of the square pictures (default 256,512,1024)")
    ->delimiter(',')
    ->check(CLI::Range(1, 4096).description(""))
    ->type_name("PIXELS");
  app->add_option("--shading", command->shading, "With light, without or both (default both)")
    ->check(NameValidator({ "both", "off", "on" }));
  AddRoundsOption(*app, command->options.rounds);
  app
    ->add_option("--longest", command->options.longestSeconds,
      "Draw what takes longer in one round only (default 20)")
    ->check(CLI::PositiveNumber.description(""))
    ->type_name("SECONDS");
  AddJsonOption(*app, command->jsonPath);
  app->callback([command] { command->Run(); });
}

void AddScalingCommand(CLI::App& bench, const std::string& commandText)
{
  const auto command = std::make_shared<ScalingCommand>();
  command->commandText = commandText;
  CLI::App* app = bench.add_subcommand("scaling", "Times over the size of two procedural volumes");
  app->footer("Writes scaling.md, .json, .png and .svg.\n"
              "Examples:\n"
              "  varimarch bench scaling -o report\n"
              "  varimarch bench scaling -o report --sides 256,512,1024 --rounds 1");
  command->sceneOptions.AddLookAndPictureTo(*app);
  AddOutputOption(*app, command->outputFolder);
  app
    ->add_option(
      "--sides", command->sides, "Voxels along each edge, ascending (default 64,128,256,512)")
    ->delimiter(',')
    ->check(CLI::Range(2, LargestProceduralSide).description(""))
    ->type_name("VOXELS");
  AddRoundsOption(*app, command->rounds);
  AddJsonOption(*app, command->jsonPath);
  app->callback([command] { command->Run(); });
}

}
