#ifndef Varimarch_CommandLine_SpeedCommand_h
#define Varimarch_CommandLine_SpeedCommand_h

#include <CLI/CLI.hpp>

#include <string>

namespace varimarch
{

/// The benchmarks of time alone, as subcommands of `varimarch bench`.
/// @param commandText  the whole command as the user gave it, for the results
void AddSpeedCommand(CLI::App& bench, const std::string& commandText);
void AddScalingCommand(CLI::App& bench, const std::string& commandText);

}

#endif
