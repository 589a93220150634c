#include "FeatureCommand.h"

#include "FeatureReport.h"
#include "Options.h"
#include "OutputFolder.h"
#include "Progress.h"
#include "Results.h"
#include "Scene/OutputFile.h"
#include "Validators.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

namespace varimarch
{

namespace
{

struct FeatureCommand
{
  std::string commandText;
  SceneOptions sceneOptions;
  std::string input;
  std::vector<std::string> only;
  int rounds = 3;
  std::string outputFolder;
  std::string jsonPath;

  bool IsWanted(const Feature& feature) const
  {
    return this->only.empty() ||
      std::find(this->only.begin(), this->only.end(), feature.name) != this->only.end();
  }

  void Run() const
  {
    const std::filesystem::path folder = OutputFolder(this->outputFolder);
    const auto [scene, volume] = this->sceneOptions.Load(this->input);
    FeaturePage page = { this->commandText, ThisMachine(), this->rounds, scene.size,
      std::filesystem::path(this->input).filename().string(), {} };
    SetInterruptNotice(folder, "nothing yet");
    {
      Progress progress("Measuring features");
      for (const Feature& feature : Features())
      {
        if (this->IsWanted(feature))
        {
          page.features.push_back(MeasureFeature(feature, scene, volume.image, this->rounds,
            [&](const std::string& step) { progress.SetActivity(step); }));
          this->Write(page, folder);
          SetInterruptNotice(folder, "features up to " + feature.name);
        }
      }
    }
    std::cout << FeatureMarkdown(page);
  }

  void Write(const FeaturePage& page, const std::filesystem::path& folder) const
  {
    const nlohmann::ordered_json results = ToJson(page);
    WriteResults(results, folder / "features.json");
    WriteResults(results, this->jsonPath);
    WriteFileWhole(folder / "features.md", FeatureMarkdown(page));
  }
};

}

void AddFeatureCommand(CLI::App& bench, const std::string& commandText)
{
  const auto command = std::make_shared<FeatureCommand>();
  command->commandText = commandText;
  CLI::App* app = bench.add_subcommand(
    "features", "Time with each feature over the time without it, ours and VTK's side by side");
  app->footer("Writes features.md and .json, after each feature: stopped, it leaves what it has.\n"
              "Examples:\n"
              "  varimarch bench features head.nii.gz -o report --size 256x256\n"
              "  varimarch bench features head.nii.gz -o report --only clipping,isosurface");
  app
    ->add_option("SCENE", command->input,
      "A scene file (.json), volume file, DICOM folder, or procedural:NAME[:XxYxZ]")
    ->required();
  command->sceneOptions.AddLookAndPictureTo(*app);
  AddOutputOption(*app, command->outputFolder);
  app->add_option("--only", command->only, "Only these features")
    ->delimiter(',')
    ->check(NameValidator(FeatureNames()));
  AddRoundsOption(*app, command->rounds);
  AddJsonOption(*app, command->jsonPath);
  app->callback([command] { command->Run(); });
}

}
