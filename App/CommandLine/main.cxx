#include "Commands.h"
#include "Parser.h"

int main(int argc, char** argv)
{
  return varimarch::RunProgram(
    "Draws medical volumes with the variation-field ray marcher, without a display.",
    VARIMARCH_VERSION, varimarch::AddCommands, argc, argv);
}
