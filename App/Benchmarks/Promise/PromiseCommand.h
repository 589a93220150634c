#ifndef Varimarch_Promise_PromiseCommand_h
#define Varimarch_Promise_PromiseCommand_h

#include <string>

namespace CLI
{
class App;
}

namespace varimarch
{

/// Adds the subcommand `promise`, which draws random scenes, judges them and prints tables.
/// @param commandText  the whole command line, for the results
void AddPromiseCommand(CLI::App& program, const std::string& commandText);

}

#endif
