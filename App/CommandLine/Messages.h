#ifndef Varimarch_CommandLine_Messages_h
#define Varimarch_CommandLine_Messages_h

#include <string>

namespace varimarch
{

/// The name under which the running program was started, without its folder.
std::string ProgramName();

/// Prints a line on stderr that begins with the program's name.
void PrintMessage(const std::string& message);

}

#endif
