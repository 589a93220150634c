#ifndef Varimarch_CommandLine_AddArchiveCommand_h
#define Varimarch_CommandLine_AddArchiveCommand_h

namespace CLI
{
class App;
}

namespace varimarch
{

/// Adds the subcommand "archive" to a program; does nothing in a build without Qt.
void AddArchiveCommand(CLI::App& program);

}

#endif
