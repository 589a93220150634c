#include "CommandLine/Parser.h"
#include "Commands.h"

int main(int argc, char** argv)
{
  return varimarch::RunProgram("Measures error and run time systematically.", VARIMARCH_VERSION,
    varimarch::AddCommands, argc, argv);
}
