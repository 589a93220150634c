#ifndef Varimarch_CommandLine_Parser_h
#define Varimarch_CommandLine_Parser_h

#include "SceneArguments.h"

#include <string>
#include <vector>

namespace CLI
{
class App;
class Validator;
}

namespace varimarch
{

// The common part of the programs' command lines. CLI11 takes seconds to compile, so only
// Parser.cxx, SettingOptions.cxx, RunProgram.cxx and the Commands.cxx of each program include it.

/// Adds subcommands to a program. A subcommand runs while CLI11 parses the command line.
/// @param commandText  the whole command line, quoted for a shell
using SubcommandAdder = void (*)(CLI::App& program, const std::string& commandText);

/// Parses a command line, runs its subcommand, and reports an exception on stderr.
/// @param summary  a sentence about the program, for --help
/// @return the exit code: 0 for success, 1 for failure, 2 for bad usage
int RunProgram(const std::string& summary, const std::string& version,
  SubcommandAdder addSubcommands, int argc, char** argv);

/// Adds VOLUME and the options of raw files and DICOM series.
void AddVolumeOptions(
  CLI::App& command, VolumeArguments& arguments, const std::string& inputDescription);

/// Adds VOLUME and all options of a scene.
void AddSceneOptions(CLI::App& command, SceneArguments& arguments);

/// Adds the options of the look, with its lights.
void AddLookOptions(CLI::App& command, SceneArguments& arguments);

/// Adds the options of look and image, for a command that has inputs of its own and chooses the
/// sampling.
void AddLookAndPictureOptions(CLI::App& command, SceneArguments& arguments);

/// Adds `--json FILE`.
void AddJsonOption(CLI::App& command, std::string& path);

/// A validator that accepts one of the names, suggests the nearest one otherwise, and lists them in
/// the help.
CLI::Validator OneOf(const std::vector<std::string>& names);

}

#endif
