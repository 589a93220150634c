#include "Commands.h"

#include "BenchMethods.h"
#include "CommandLine/Parser.h"
#include "FeatureList.h"
#include "Promise/PromiseCommand.h"
#include "Scene/SceneNames.h"
#include "SoakBench.h"

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

void AddSceneArgument(CLI::App& command, std::string& input)
{
  command
    .add_option(
      "SCENE", input, "A scene file (.json), volume file, DICOM folder, or procedural:NAME[:XxYxZ]")
    ->required();
}

void AddRoundsOption(CLI::App& command, int& rounds)
{
  command.add_option("--rounds", rounds, "Number of measurements of each (default 3)")
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
  arguments->options.orbitFrames = 31;
  arguments->report.commandText = commandText;
  CLI::App* app = program.add_subcommand(
    "work-precision", "Plot error against run time for our mapper's settings and VTK's mappers");
  app->footer(
    "Writes a self-contained work-precision.html, and .md, .csv and .json, with each scene's\n"
    "plots as PNG and SVG and images as PNG, after each scene, so an interrupted run keeps its\n"
    "results.\n"
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
  app->add_option("--methods", arguments->methods, "Methods to measure (default all)")
    ->delimiter(',')
    ->check(OneOf(BenchMethodNames()));
  AddRoundsOption(*app, arguments->options.rounds);
  AddLongestOption(*app, arguments->options.longestSeconds,
    "Skip finer settings once an image takes longer (default 3)");
  app
    ->add_option("--orbit", arguments->options.orbitFrames,
      "Frames of an orbit in which changes of the error are measured (default 31), or 0")
    ->check(CLI::IsMember({ 0 }).description("") | CLI::Range(2, 10000).description(""))
    ->type_name("FRAMES");
  app->callback([arguments] { RunWorkPrecision(*arguments); });
}

void AddPublishedCommand(CLI::App& program, const std::string& commandText)
{
  const auto arguments = std::make_shared<PublishedArguments>();
  arguments->report.commandText = commandText;
  CLI::App* app = program.add_subcommand(
    "published", "Measure the scenes of two papers beside their published figures");
  app->footer("Scenes: Banquero, Ortiz, Rossi 2016, tables 1 and 2, and Volt 2009. Volumes that\n"
              "are missing in the folder are skipped and listed.\n"
              "Example:\n"
              "  varimarch-bench published --volumes volumes -o published");
  app
    ->add_option("--volumes", arguments->options.folder,
      "The folder of the papers' volumes (default: $VARIMARCH_VOLUMES)")
    ->envname("VARIMARCH_VOLUMES")
    ->check(CLI::ExistingDirectory.description(""))
    ->type_name("FOLDER")
    ->required();
  AddReportOptions(*app, arguments->report);
  app->add_option("--side", arguments->options.side, "Side of the square images (default 512)")
    ->check(CLI::Range(1, 4096).description(""))
    ->type_name("PIXELS");
  AddRoundsOption(*app, arguments->options.rounds);
  app->callback([arguments] { RunPublished(*arguments); });
}

void AddSceneOptions(CLI::App& command, BenchSceneArguments& scenes)
{
  command.add_option("SCENES", scenes.inputs,
    "Scene files (.json), volume files, DICOM folders, or procedural:NAME[:XxYxZ]");
  command
    .add_option("--volumes", scenes.volumes,
      "A folder of well-known volumes, each drawn soft, dense and as a thin peak")
    ->check(CLI::ExistingDirectory.description(""))
    ->type_name("FOLDER");
  command
    .add_option(
      "--only", scenes.only, "Draw only scenes of --volumes whose names start with one of these")
    ->delimiter(',')
    ->type_name("NAMES");
}

void AddSpeedOptions(CLI::App& command, const std::shared_ptr<SpeedArguments>& arguments)
{
  AddSceneOptions(command, arguments->scenes);
  AddReportOptions(command, arguments->report);
  command
    .add_option(
      "--sides", arguments->options.sides, "Sides of the square images (default 256,512,1024)")
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
      "--shading", setShaded, "Draw with shading, without, or both (default both)")
    ->check(OneOf({ "both", "off", "on" }));
  AddRoundsOption(command, arguments->options.rounds);
  AddLongestOption(command, arguments->options.longestSeconds,
    "Draw frames that take longer in only one round (default 20)");
}

void AddSpeedCommand(CLI::App& program, const std::string& commandText)
{
  const auto arguments = std::make_shared<SpeedArguments>();
  arguments->report.commandText = commandText;
  CLI::App* app = program.add_subcommand(
    "speed", "Compare times with VTK's mappers, our march without a field and the published one");
  app->footer("Writes speed.md, .json, .png and .svg.\n"
              "Examples:\n"
              "  varimarch-bench speed --volumes volumes -o report\n"
              "  varimarch-bench speed --volumes volumes --only bonsai,tooth-soft -o report\n"
              "  varimarch-bench speed Data/Scenes/*.json -o report --sides 256 --shading off");
  AddSpeedOptions(*app, arguments);
  app->callback([arguments] { RunSpeed(*arguments); });
}

void AddLightCostOptions(CLI::App& command, LightCostArguments& arguments)
{
  AddSceneOptions(command, arguments.scenes);
  AddReportOptions(command, arguments.report);
  command.add_option("--side", arguments.options.side, "Side of the square images (default 512)")
    ->check(CLI::Range(1, 4096).description(""))
    ->type_name("PIXELS");
  command
    .add_option(
      "--tolerance", arguments.options.errorTolerance, "The error tolerance (default 1/64)")
    ->check(CLI::Range(1e-4, 1.0).description(""))
    ->type_name("ERROR");
  AddRoundsOption(command, arguments.options.rounds);
}

void AddLightCostCommand(
  CLI::App& program, const std::string& commandText, const LightFeature& feature)
{
  const std::string name = feature.name;
  const auto arguments = std::make_shared<LightCostArguments>();
  arguments->report.commandText = commandText;
  arguments->options.feature = feature;
  CLI::App* app = program.add_subcommand(
    name, std::string("Measure the cost of ") + feature.text + ": still, turning and dragged");
  const std::string command = "  varimarch-bench " + name;
  app->footer("Writes " + name + ".md and .json after each scene.\nExamples:\n" + command +
    " --volumes volumes -o report\n" + command + " head.nii.gz -o report --side 256");
  AddLightCostOptions(*app, *arguments);
  app
    ->add_option("--tolerances", arguments->options.tolerances,
      "The tolerances whose errors are measured (default 1/16, 1/32, 1/64, 1/128, 1/255)")
    ->delimiter(',')
    ->check(CLI::Range(1e-4, 1.0).description(""))
    ->type_name("ERRORS");
  app
    ->add_option("--views", arguments->options.views,
      "The number of views of each scene in which they are measured (default 4)")
    ->check(CLI::Range(1, 360).description(""))
    ->type_name("N");
  app->callback([arguments] { RunLightCost(*arguments); });
}

void AddLightCommand(CLI::App* app, void (*run)(const LightCostArguments&),
  const std::string& files, const std::string& commandText)
{
  const auto arguments = std::make_shared<LightCostArguments>();
  arguments->report.commandText = commandText;
  app->footer("Writes " + app->get_name() + files + " after each scene.\nExample:\n" +
    "  varimarch-bench " + app->get_name() + " --volumes volumes -o report --side 256");
  AddLightCostOptions(*app, *arguments);
  app->callback([=] { run(*arguments); });
}

void AddScalingCommand(CLI::App& program, const std::string& commandText)
{
  const auto arguments = std::make_shared<ScalingArguments>();
  arguments->report.commandText = commandText;
  CLI::App* app =
    program.add_subcommand("scaling", "Measure times over the size of two procedural volumes");
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
    "features", "Measure the cost of each feature, in our mapper and in VTK's");
  app->footer(
    "Writes features.md and .json after each feature, so an interrupted run keeps its results.\n"
    "Examples:\n"
    "  varimarch-bench features head.nii.gz -o report --size 256x256\n"
    "  varimarch-bench features head.nii.gz -o report --only clipping,isosurface");
  AddSceneArgument(*app, arguments->input);
  AddLookAndPictureOptions(*app, arguments->scene);
  AddReportOptions(*app, arguments->report);
  app->add_option("--only", arguments->only, "Features to measure (default all)")
    ->delimiter(',')
    ->check(OneOf(FeatureNames()));
  AddRoundsOption(*app, arguments->rounds);
  app->callback([arguments] { RunFeatures(*arguments); });
}

void AddShaderCostCommand(CLI::App& program, const std::string& commandText)
{
  const auto arguments = std::make_shared<ShaderCostArguments>();
  arguments->report.commandText = commandText;
  CLI::App* app =
    program.add_subcommand("shaders", "Ask the driver for the cost of each shader, unlit and lit");
  app->footer("Writes shaders.md and .json. Mesa's drivers also tell the instructions.\n"
              "Example:\n"
              "  varimarch-bench shaders procedural:torso:32x32x24 -o report");
  AddSceneArgument(*app, arguments->input);
  AddLookAndPictureOptions(*app, arguments->scene);
  AddReportOptions(*app, arguments->report);
  app->callback([arguments] { RunShaderCosts(*arguments); });
}

void AddExtremesCommand(CLI::App& program, const std::string& commandText)
{
  const auto arguments = std::make_shared<ExtremesArguments>();
  arguments->commandText = commandText;
  CLI::App* app = program.add_subcommand(
    "extremes", "Measure errors and times of stiff and extreme scenes, in our mapper and in VTK's");
  app->footer("Writes extremes.md and .csv after each scene.\n"
              "Example:\n  varimarch-bench extremes -o extremes");
  app->add_option("-o,--output", arguments->outputFolder, "The folder for the report")
    ->type_name("FOLDER")
    ->required();
  app->add_option("--only", arguments->only, "Draw only scenes whose names start with one of these")
    ->delimiter(',')
    ->type_name("NAMES");
  app->callback([arguments] { RunExtremes(*arguments); });
}

void AddOrderCommand(CLI::App& program, const std::string& commandText)
{
  const auto arguments = std::make_shared<OrderArguments>();
  arguments->report.commandText = commandText;
  CLI::App* app = program.add_subcommand(
    "order", "Measure orders of convergence under refinement of steps, grid and pixels");
  app->footer("Writes order.md, .csv and .json, and a plot of each experiment as PNG and SVG.\n"
              "Example:\n  varimarch-bench order -o order");
  AddReportOptions(*app, arguments->report);
  app
    ->add_option(
      "--side", arguments->side, "Side of the square images, a multiple of 8 (default 128)")
    ->check(CLI::Range(16, 1024).description(""))
    ->type_name("PIXELS");
  app->callback([arguments] { RunOrder(*arguments); });
}

void AddReferencesCommand(CLI::App& program)
{
  const auto arguments = std::make_shared<ReferencesArguments>();
  CLI::App* app = program.add_subcommand(
    "references", "Write reference images by which other renderers can be judged");
  app->footer("Writes NAME.npy and NAME.json of each scene, and the volumes as NRRD. With\n"
              "--renderer it writes only the images that this mapper draws.\n"
              "Examples:\n"
              "  varimarch-bench references -o Data/References\n"
              "  varimarch-bench references -o pictures --renderer vtk-gpu");
  app->add_option("-o,--output", arguments->outputFolder, "The folder for the files")
    ->type_name("FOLDER")
    ->required();
  app
    ->add_option_function<std::string>(
      "--renderer",
      [arguments](const std::string& name)
      { arguments->renderer = ValueOf(MapperKindNames(), name); },
      "The mapper that draws (default: the reference integrator)")
    ->check(OneOf(NamesOf(MapperKindNames())));
  app->callback([arguments] { RunReferences(*arguments); });
}

void AddSoakCommand(CLI::App& program, const std::string& commandText)
{
  const auto arguments = std::make_shared<SoakArguments>();
  arguments->report.commandText = commandText;
  CLI::App* app = program.add_subcommand(
    "soak", "Render for a long time, with edits and other voxels, and watch memory and speed");
  app->footer("Writes soak.md and .json after each tenth of the frames.\n"
              "Examples:\n"
              "  varimarch-bench soak head.nii.gz -o report\n"
              "  varimarch-bench soak procedural:torso:128x128x96 -o report --frames 100000");
  AddSceneArgument(*app, arguments->input);
  AddLookAndPictureOptions(*app, arguments->scene);
  AddReportOptions(*app, arguments->report);
  app->add_option("--frames", arguments->frames, "Number of frames (default 20000)")
    ->check(CLI::Range(SoakParts, 100000000).description(""))
    ->type_name("N");
  app->callback([arguments] { RunSoak(*arguments); });
}

void AddTimesCommand(CLI::App& program, const std::string& commandText)
{
  const auto arguments = std::make_shared<TimesArguments>();
  arguments->report.commandText = commandText;
  CLI::App* app = program.add_subcommand(
    "times", "Play the times of a scan: other voxels in every frame; watch memory and speed");
  app->footer("Writes times.md and .json. Example:\n"
              "  varimarch-bench times procedural:torso:256x256x256 -o report --size 512x512");
  AddSceneArgument(*app, arguments->input);
  AddLookAndPictureOptions(*app, arguments->scene);
  AddReportOptions(*app, arguments->report);
  app->add_option("--times", arguments->times, "Number of times (default 20)")
    ->check(CLI::Range(2, 1000).description(""))
    ->type_name("N");
  app->add_option("--frames", arguments->frames, "Number of frames (default 1000)")
    ->check(CLI::Range(1, 100000000).description(""))
    ->type_name("N");
  app->callback([arguments] { RunTimes(*arguments); });
}

}

void AddCommands(CLI::App& program, const std::string& commandText)
{
  AddWorkPrecisionCommand(program, commandText);
  AddPublishedCommand(program, commandText);
  AddSpeedCommand(program, commandText);
  for (const LightFeature& feature : LightFeatures())
  {
    AddLightCostCommand(program, commandText, feature);
  }
  AddLightCommand(program.add_subcommand("light-methods",
                    "Measure our shadows beside those of others: error, time and memory"),
    RunLightMethods, ".md, .csv and .json", commandText);
  AddLightCommand(
    program.add_subcommand("shadows-beside", "Measure shadows of geometry and of other volumes"),
    RunBesideCost, ".md and .json", commandText);
  AddScalingCommand(program, commandText);
  AddFeatureCommand(program, commandText);
  AddShaderCostCommand(program, commandText);
  AddExtremesCommand(program, commandText);
  AddOrderCommand(program, commandText);
  AddReferencesCommand(program);
  AddSoakCommand(program, commandText);
  AddTimesCommand(program, commandText);
  AddPromiseCommand(program, commandText);
}

}
