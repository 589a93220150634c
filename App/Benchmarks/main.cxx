#include "Benchmark.h"
#include "CommandLine/Parser.h"

int main(int argc, char** argv)
{
  return varimarch::RunProgram("Measures the error and the run time of volume mappers.",
    VARIMARCH_VERSION, varimarch::AddBenchmarks, argc, argv);
}
