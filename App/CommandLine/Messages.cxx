#include "Messages.h"

#include <cerrno>
#include <iostream>

namespace varimarch
{

std::string ProgramName()
{
  return program_invocation_short_name;
}

void PrintMessage(const std::string& message)
{
  std::cerr << ProgramName() + ": " + message + "\n";
}

}
