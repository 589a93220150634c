#include "CommandLine/Parser.h"
#include "Commands.h"

int main(int argc, char** argv)
{
  return varimarch::RunProgram("Measures the error and the run time of volume mappers.",
    VARIMARCH_VERSION, varimarch::AddCommands, argc, argv);
}
