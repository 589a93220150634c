#ifndef Varimarch_CommandLine_Commands_h
#define Varimarch_CommandLine_Commands_h

#include <CLI/CLI.hpp>

#include <string>

namespace varimarch
{

/// Each adds a subcommand that does its work while CLI11 parses, and reports failure by an
/// exception.
/// @param commandText  the whole command as the user gave it, for the results
void AddBenchCommand(CLI::App& program, const std::string& commandText);
void AddCompareCommand(CLI::App& program, const std::string& commandText);
void AddInfoCommand(CLI::App& program, const std::string& commandText);
void AddRenderCommand(CLI::App& program, const std::string& commandText);

}

#endif
