#include "Commands.h"

#include "BenchMethods.h"
#include "CommandLine/Parser.h"
#include "FeatureList.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace varimarch
{

namespace
{

void AddReportOptions(CLI::App& command, ReportArguments& report)
{
  command.add_option("-o,--output", report.outputFolder, "The folder for the report")
    ->type_name("FOLDER")
    ->required();
  AddJsonOption(command, report.jsonPath);
}

void AddRoundsOption(CLI::App& command, int& rounds)
{
  command.add_option("--rounds", rounds, "Times to measure each (default 3)")
    ->check(CLI::Range(1, 10000).description(""))
    ->type_name("N");
}

void AddLongestOption(CLI::App& command, double& seconds, const std::string& description)
{
  command.add_option("--longest", seconds, description)
    ->check(CLI::PositiveNumber.description(""))
    ->type_name("SECONDS");
}

void AddWorkPrecisionCommand(CLI::App& program, const std::string& commandText)
{
  const auto arguments = std::make_shared<WorkPrecisionArguments>();
  arguments->report.commandText = commandText;
  CLI::App* app = program.add_subcommand(
    "work-precision", "Error against run time of our mapper's choices and of VTK's mappers");
  app->footer("Writes work-precision.html, which needs no other file, .md, .csv and .json, and "
              "each scene's plots\n"
              "as PNG and SVG, after each scene: stopped, it leaves what it has.\n"
              "Examples:\n"
              "  varimarch-bench work-precision head.nii.gz -o report --size 256x256\n"
              "  varimarch-bench work-precision Data/Scenes/*.json -o report --rounds 5\n"
              "  varimarch-bench work-precision scene.json -o report --methods optical,vtk-gpu");
  app
    ->add_option("SCENES", arguments->inputs,
      "Scene files (.json), volume files, DICOM folders, or procedural:NAME[:XxYxZ]")
    ->required();
  AddLookAndPictureOptions(*app, arguments->scene);
  AddReportOptions(*app, arguments->report);
  app->add_option("--methods", arguments->methods, "Only these (default all)")
    ->delimiter(',')
    ->check(OneOf(BenchMethodNames()));
  AddRoundsOption(*app, arguments->options.rounds);
  AddLongestOption(*app, arguments->options.longestSeconds,
    "Leave out finer settings when a picture took longer (default 3)");
  app->callback([arguments] { RunWorkPrecision(*arguments); });
}

void AddPublishedCommand(CLI::App& program, const std::string& commandText)
{
  const auto arguments = std::make_shared<PublishedArguments>();
  arguments->report.commandText = commandText;
  CLI::App* app =
    program.add_subcommand("published", "The scenes of two papers, with their figures beside ours");
  app->footer(
    "Scenes: Banquero, Ortiz, Rossi 2016, tables 1 and 2, and Volt 2009. Volumes that the folder\n"
    "does not hold are left out, and named.\n"
    "Example:\n"
    "  varimarch-bench published --volumes volumes -o published");
  app
    ->add_option("--volumes", arguments->options.folder,
      "The folder of the papers' volumes (default: the environment's VARIMARCH_VOLUMES)")
    ->envname("VARIMARCH_VOLUMES")
    ->check(CLI::ExistingDirectory.description(""))
    ->type_name("FOLDER")
    ->required();
  AddReportOptions(*app, arguments->report);
  app->add_option("--side", arguments->options.side, "Of the square pictures (default 512)")
    ->check(CLI::Range(1, 4096).description(""))
    ->type_name("PIXELS");
  AddRoundsOption(*app, arguments->options.rounds);
  app->callback([arguments] { RunPublished(*arguments); });
}

void AddSpeedOptions(CLI::App& command, const std::shared_ptr<SpeedArguments>& arguments)
{
  command.add_option("SCENES", arguments->inputs,
    "Scene files (.json), volume files, DICOM folders, or procedural:NAME[:XxYxZ]");
  command
    .add_option("--volumes", arguments->volumes,
      "A folder of well-known volumes, each seen soft, dense and as a thin peak")
    ->check(CLI::ExistingDirectory.description(""))
    ->type_name("FOLDER");
  command.add_option("--only", arguments->only, "Of these, the scenes whose names start so")
    ->delimiter(',')
    ->type_name("NAMES");
  AddReportOptions(command, arguments->report);
  command
    .add_option(
      "--sides", arguments->options.sides, "Of the square pictures (default 256,512,1024)")
    ->delimiter(',')
    ->check(CLI::Range(1, 4096).description(""))
    ->type_name("PIXELS");
  const auto setShaded = [arguments](const std::string& shading)
  {
    arguments->options.shaded =
      shading == "both" ? std::vector<bool>{ false, true } : std::vector<bool>{ shading == "on" };
  };
  command
    .add_option_function<std::string>(
      "--shading", setShaded, "With light, without or both (default both)")
    ->check(OneOf({ "both", "off", "on" }));
  AddRoundsOption(command, arguments->options.rounds);
  AddLongestOption(command, arguments->options.longestSeconds,
    "Draw what takes longer in one round only (default 20)");
}

void AddSpeedCommand(CLI::App& program, const std::string& commandText)
{
  const auto arguments = std::make_shared<SpeedArguments>();
  arguments->report.commandText = commandText;
  CLI::App* app = program.add_subcommand(
    "speed", "Times against VTK's mappers, our march without field and the published one");
  app->footer("Writes speed.md, .json, .png and .svg.\n"
              "Examples:\n"
              "  varimarch-bench speed --volumes volumes -o report\n"
              "  varimarch-bench speed --volumes volumes --only bonsai,tooth-soft -o report\n"
              "  varimarch-bench speed Data/Scenes/*.json -o report --sides 256 --shading off");
  AddSpeedOptions(*app, arguments);
  app->callback([arguments] { RunSpeed(*arguments); });
}

void AddScalingCommand(CLI::App& program, const std::string& commandText)
{
  const auto arguments = std::make_shared<ScalingArguments>();
  arguments->report.commandText = commandText;
  CLI::App* app =
    program.add_subcommand("scaling", "Times over the size of two procedural volumes");
  app->footer("Writes scaling.md, .json, .png and .svg.\n"
              "Examples:\n"
              "  varimarch-bench scaling -o report\n"
              "  varimarch-bench scaling -o report --sides 256,512,1024 --rounds 1");
  AddLookAndPictureOptions(*app, arguments->scene);
  AddReportOptions(*app, arguments->report);
  app
    ->add_option(
      "--sides", arguments->sides, "Voxels along each edge, ascending (default 64,128,256,512)")
    ->delimiter(',')
    ->check(CLI::Range(2, LargestProceduralSide).description(""))
    ->type_name("VOXELS");
  AddRoundsOption(*app, arguments->rounds);
  app->callback([arguments] { RunScaling(*arguments); });
}

void AddFeatureCommand(CLI::App& program, const std::string& commandText)
{
  const auto arguments = std::make_shared<FeatureArguments>();
  arguments->report.commandText = commandText;
  CLI::App* app = program.add_subcommand(
    "features", "Time with each feature over the time without it, ours and VTK's side by side");
  app->footer("Writes features.md and .json, after each feature: stopped, it leaves what it has.\n"
              "Examples:\n"
              "  varimarch-bench features head.nii.gz -o report --size 256x256\n"
              "  varimarch-bench features head.nii.gz -o report --only clipping,isosurface");
  app
    ->add_option("SCENE", arguments->input,
      "A scene file (.json), volume file, DICOM folder, or procedural:NAME[:XxYxZ]")
    ->required();
  AddLookAndPictureOptions(*app, arguments->scene);
  AddReportOptions(*app, arguments->report);
  app->add_option("--only", arguments->only, "Only these features")
    ->delimiter(',')
    ->check(OneOf(FeatureNames()));
  AddRoundsOption(*app, arguments->rounds);
  app->callback([arguments] { RunFeatures(*arguments); });
}

}

void AddCommands(CLI::App& program, const std::string& commandText)
{
  AddWorkPrecisionCommand(program, commandText);
  AddPublishedCommand(program, commandText);
  AddSpeedCommand(program, commandText);
  AddScalingCommand(program, commandText);
  AddFeatureCommand(program, commandText);
}

}
