#ifndef Varimarch_CommandLine_FeatureCommand_h
#define Varimarch_CommandLine_FeatureCommand_h

#include <CLI/CLI.hpp>

#include <string>

namespace varimarch
{

/// What each feature costs, as a subcommand of `varimarch bench`.
/// @param commandText  the whole command as the user gave it, for the results
void AddFeatureCommand(CLI::App& bench, const std::string& commandText);

}

#endif
