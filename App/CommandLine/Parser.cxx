#include "Parser.h"

#include "ArgumentChecks.h"
#include "Scene/Json/SceneNames.h"
#include "Scene/Looks/Presets.h"
#include "SettingOptions.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <limits>

namespace varimarch
{

namespace
{

// A validator that accepts finite numbers above a limit.
CLI::Validator Above(double limit)
{
  const auto check = [limit](std::string& text)
  {
    double number = 0.0;
    const bool good = CLI::detail::lexical_cast(text, number) && number > limit &&
      number < std::numeric_limits<double>::infinity();
    return good
      ? std::string()
      : "expected a number > " + CLI::detail::to_string(limit) + ", found \"" + text + "\"";
  };
  return CLI::Validator(check, "");
}

// A validator that accepts sizes such as "640x480".
template <std::size_t count>
CLI::Validator IsSides(const std::string& example, int smallest, int largest)
{
  const auto check = [=](std::string& text)
  { return SidesProblem<count>(text, example, smallest, largest); };
  return CLI::Validator(check, "");
}

// Adds an option that takes one of the names in a table.
template <class Value, class Target>
CLI::Option* AddChoice(CLI::App& command, const std::string& name, Target& target,
  const NameTable<Value>& table, const std::string& description)
{
  return command
    .add_option_function<std::string>(
      name, [&](const std::string& word) { target = ValueOf(table, word); }, description)
    ->check(OneOf(NamesOf(table)));
}

void AddRawOptions(CLI::App& command, RawLayout& raw)
{
  const std::string group = "Raw files (no header)";
  CLI::Option* dimensions =
    command
      .add_option_function<std::string>(
        "--raw-dimensions",
        [&](const std::string& text) { raw.dimensions = *Sides<3>(text, 1, LargestVolumeSide); },
        "Number of voxels along each axis")
      ->check(IsSides<3>("256x256x128", 1, LargestVolumeSide))
      ->type_name("XxYxZ")
      ->group(group);
  command.add_option("--raw-type", raw.type, "Type of voxels (default uint8)")
    ->check(OneOf(NamesOf(RawTypeNames())))
    ->needs(dimensions)
    ->group(group);
  command
    .add_option_function<std::vector<double>>(
      "--raw-spacing",
      [&](const std::vector<double>& spacing)
      { std::copy(spacing.begin(), spacing.end(), raw.spacingMm.begin()); },
      "Voxel spacing in mm (default 1,1,1)")
    ->check(Above(0.0))
    ->delimiter(',')
    ->expected(3)
    ->type_name("X,Y,Z")
    ->needs(dimensions)
    ->group(group);
  AddChoice(
    command, "--raw-byte-order", raw.bigEndian, ByteOrderNames(), "Byte order (default little)")
    ->needs(dimensions)
    ->group(group);
  command
    .add_option(
      "--raw-header-bytes", raw.headerBytes, "Bytes to skip before the first voxel (default 0)")
    ->check(CLI::Range(std::int64_t(0), std::numeric_limits<std::int64_t>::max()).description(""))
    ->type_name("N")
    ->needs(dimensions)
    ->group(group);
}

void AddRegionsOption(CLI::App& command, SceneArguments& arguments)
{
  command
    .add_option("--regions", arguments.regions,
      "File with regions of value and gradient magnitude that replace the curves of\n"
      "the look: an array as of the key \"regions\" of a look")
    ->type_name("FILE")
    ->group("Look");
}

// Adds the options that choose a series, a kind of volume in it, and how its slices are stacked.
void AddSeriesOptions(CLI::App& command, VolumeArguments& arguments)
{
  command
    .add_option("--series", arguments.series,
      "The DICOM series to read: its number in the list that is printed without\n"
      "this option, its SeriesInstanceUID, or an unambiguous prefix of that (default 1)")
    ->type_name("SERIES");
  command
    .add_option("--kind", arguments.kind,
      "The kind of volume to read of a series with several, such as another echo,\n"
      "b-value, view or station: its number in the list that is printed without this\n"
      "option (default 1)")
    ->check(CLI::Range(1, LargestKind).description(""))
    ->type_name("N");
  CLI::Option* const rectify = command.add_flag(
    "--rectify", arguments.rectify, "Resample tilted or unevenly spaced slices on an even grid");
  command
    .add_flag("--as-scanned", arguments.asScanned,
      "Keep slices at uneven distances, which are resampled otherwise if gaps are small")
    ->excludes(rectify);
}

}

void AddVolumeOptions(
  CLI::App& command, VolumeArguments& arguments, const std::string& inputDescription)
{
  command.add_option("VOLUME", arguments.input, inputDescription)->required();
  AddSeriesOptions(command, arguments);
  command
    .add_option("--memory", arguments.memoryMegabytes,
      "Memory that the program may use in MB; a volume that needs more than a quarter\n"
      "of it is drawn from its file, if its voxels are not compressed, and a level of\n"
      "OME-Zarr or HDF5 that needs more than half from its chunks (default: all)")
    ->check(CLI::PositiveNumber)
    ->type_name("MB");
  command
    .add_option("--level", arguments.level,
      "The level to read of OME-Zarr, Imaris or BigDataViewer, from 0, the finest\n"
      "(default: the finest that fits in half of the free memory or can be drawn\n"
      "from its chunks)")
    ->check(CLI::Range(0, LargestLevel).description(""))
    ->type_name("N");
  command
    .add_option("--channel", arguments.channel, "The channel to read of these formats, from 0")
    ->check(CLI::Range(0, LargestChannel).description(""))
    ->type_name("N");
  command
    .add_option("--time", arguments.time,
      "The time to read if there are several: its number, counted from 0, or its\n"
      "seconds such as 1.4s, of which the nearest is read (default 0)")
    ->check(CLI::Validator([](std::string& text) { return TimeProblem(text); }, ""))
    ->type_name("TIME");
  command.add_flag("--files-are-times", arguments.filesAreTimes,
    "Take the volumes in a folder, or those beside a file whose names differ from its\n"
    "own only in their last number, as times");
  AddRawOptions(command, arguments.raw);
}

void AddSceneOptions(CLI::App& command, SceneArguments& arguments)
{
  AddVolumeOptions(command, arguments.volume,
    "A volume file, a folder with a DICOM series, a scene file (.json), or\n"
    "procedural:shells|marschner-lobb|torso|checkerboard|ramp[:XxYxZ]");
  AddLookAndPictureOptions(command, arguments);
  AddSamplingSettings(command, arguments);
}

void AddLookOptions(CLI::App& command, SceneArguments& arguments)
{
  const std::string group = "Look";
  CLI::Option* presetOption = command
                                .add_option("--preset", arguments.preset,
                                  "Built-in look (default: ct-bone for CT, else mr-head)")
                                ->check(OneOf(PresetNames()))
                                ->group(group);
  CLI::Option* fileOption =
    command.add_option("--transfer-function", arguments.transferFunction, "File with looks")
      ->type_name("FILE")
      ->excludes(presetOption)
      ->group(group);
  command.add_option("--look", arguments.lookName, "Name of the look in a file that holds several")
    ->type_name("NAME")
    ->needs(fileOption)
    ->group(group);
  AddRegionsOption(command, arguments);
  AddLookSettings(command, arguments);
}

void AddLookAndPictureOptions(CLI::App& command, SceneArguments& arguments)
{
  AddLookOptions(command, arguments);
  AddImageSettings(command, arguments);
}

void AddJsonOption(CLI::App& command, std::string& path)
{
  command.add_option("--json", path, "Also write the results as JSON")->type_name("FILE");
}

CLI::Validator OneOf(const std::vector<std::string>& names)
{
  const auto check = [names](std::string& text) { return NameProblem(text, names); };
  return CLI::Validator(check, CLI::detail::join(names, "|"));
}

}
