#include "Commands.h"

#include "Options.h"
#include "Results.h"
#include "Scene/ImageStatistics.h"
#include "VolumeText.h"

#include <iostream>
#include <memory>

namespace varimarch
{

namespace
{

struct InfoCommand
{
  std::string commandText;
  VolumeOptions volumeOptions;
  int bins = 32;
  std::string jsonPath;

  void Run() const
  {
    const LoadedVolume volume =
      LoadVolumeReporting(this->volumeOptions.SourceOf(this->volumeOptions.Input()));
    const ImageStatistics statistics(volume.image);
    nlohmann::ordered_json results = ResultsOf(this->commandText, volume);
    results["volume"].update(VolumeJson(volume, statistics, this->bins));
    WriteResults(results, this->jsonPath);
    std::cout << VolumeText(this->volumeOptions.Input(), volume, statistics, this->bins);
  }
};

}

void AddInfoCommand(CLI::App& program, const std::string& commandText)
{
  const auto command = std::make_shared<InfoCommand>();
  command->commandText = commandText;
  CLI::App* app = program.add_subcommand("info", "Tell what a volume is and how its values lie");
  app->footer("Examples:\n"
              "  varimarch info head.nii.gz\n"
              "  varimarch info dicom-folder --bins 64\n"
              "  varimarch info dicom-folder --series 2\n"
              "  varimarch info scan.raw --raw-dimensions 256x256x128 --json scan.json");
  command->volumeOptions.AddTo(*app,
    "A volume file, a folder with a DICOM series, or\n"
    "procedural:shells|marschner-lobb|torso[:XxYxZ]");
  app->add_option("--bins", command->bins, "Bars of the histogram (default 32)")
    ->check(CLI::Range(1, 65536).description(""))
    ->type_name("N");
  AddJsonOption(*app, command->jsonPath);
  app->callback([command] { command->Run(); });
}

}
