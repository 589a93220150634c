#include "Benchmark.h"
#include "CommandLine/Parser.h"
#include "CommandLine/Progress.h"
#include "Promise/PromiseRun.h"

#include <CLI/CLI.hpp>

namespace varimarch
{

namespace
{

std::vector<std::string> KindNames()
{
  std::vector<std::string> names;
  for (const PromiseKind& kind : PromiseKinds())
  {
    names.push_back(kind.name);
  }
  return names;
}

void AddPromiseOptions(CLI::App& command, PromiseOptions& options)
{
  command.add_option("--scenes", options.scenes, "Number of scenes (default 200)")
    ->check(CLI::Range(1, 10000000).description(""))
    ->type_name("N");
  command.add_option("--seed", options.seed, "Seed of the first scene of each kind (default 1)")
    ->type_name("SEED");
  command.add_option("--only", options.only, "Kinds of scenes to draw (default all)")
    ->delimiter(',')
    ->check(OneOf(KindNames()));
  command
    .add_option(
      "--size", options.side, "Largest height and width of pictures (default: those of each kind)")
    ->check(CLI::Range(2, 1024).description(""))
    ->type_name("PIXELS");
}

void MeasurePromise(const PromiseOptions& options, BenchResults& results)
{
  constexpr std::size_t WriteEvery = 100;
  for (const PromiseKind& kind : PromiseKinds())
  {
    results.json["kinds"].push_back({ { "name", kind.name }, { "isLit", kind.isLit } });
  }
  nlohmann::ordered_json& pictures = results.json["pictures"] = nlohmann::ordered_json::array();
  const auto write = [&] { results.Write(std::to_string(pictures.size()) + " pictures"); };
  Progress progress("Drawing and judging random scenes");
  RunPromise(options,
    [&](const PromisePicture& picture)
    {
      pictures.push_back(ToJson(picture));
      progress.SetActivity(std::to_string(pictures.size()) + " pictures judged");
      if (pictures.size() % WriteEvery == 0)
      {
        write();
      }
    });
  write();
}

}

Benchmark PromiseBenchmark()
{
  Benchmark benchmark = MakeBenchmark("promise",
    "Draw random scenes and judge by an integrator of its own whether they keep their tolerance",
    "Results hold, for each picture, the command that draws its scene alone. They are printed\n"
    "without --output.\n"
    "Examples:\n"
    "  varimarch-bench promise --scenes 500 --seed 1 -o report\n"
    "  varimarch-bench promise --only shadow-bands,soft --seed 7 --scenes 20 -o report",
    AddPromiseOptions, MeasurePromise);
  benchmark.output = BenchOutput::PrintedResults;
  return benchmark;
}

}
