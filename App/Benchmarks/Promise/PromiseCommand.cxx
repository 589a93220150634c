#include "PromiseCommand.h"

#include "CommandLine/OutputFolder.h"
#include "CommandLine/Parser.h"
#include "CommandLine/Progress.h"
#include "CommandLine/Results.h"
#include "PromiseReport.h"
#include "PromiseRun.h"
#include "Scene/OutputFile.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>
#include <memory>

namespace varimarch
{

namespace
{

struct PromiseArguments
{
  std::string commandText;  ///< the whole command line, for the results
  std::string outputFolder; ///< empty: results are only printed
  std::string jsonPath;     ///< another file for the results; empty: none
  PromiseOptions options;
};

// Writes what is known so far.
void Write(const PromiseArguments& arguments, const std::vector<PromisePicture>& pictures)
{
  const nlohmann::ordered_json json = { { "command", arguments.commandText },
    { "pictures", PromiseJson(pictures) } };
  if (!arguments.outputFolder.empty())
  {
    const std::filesystem::path folder = OutputFolder(arguments.outputFolder);
    WriteFileWhole(folder / "promise.md",
      "# The promise, judged\n\n`" + arguments.commandText + "`\n\n" + PromiseMarkdown(pictures));
    WriteResults(json, folder / "promise.json");
  }
  WriteResults(json, arguments.jsonPath);
}

void Run(const PromiseArguments& arguments)
{
  constexpr std::size_t WriteEvery = 100;
  std::vector<PromisePicture> pictures;
  {
    Progress progress("Drawing and judging random scenes");
    RunPromise(arguments.options,
      [&](const PromisePicture& picture)
      {
        pictures.push_back(picture);
        progress.SetActivity(std::to_string(pictures.size()) + " pictures judged");
        if (pictures.size() % WriteEvery == 0)
        {
          Write(arguments, pictures);
        }
      });
  }
  Write(arguments, pictures);
  std::cout << PromiseMarkdown(pictures);
}

std::vector<std::string> KindNames()
{
  std::vector<std::string> names;
  for (const PromiseKind& kind : PromiseKinds())
  {
    names.push_back(kind.name);
  }
  return names;
}

}

void AddPromiseCommand(CLI::App& program, const std::string& commandText)
{
  const auto arguments = std::make_shared<PromiseArguments>();
  arguments->commandText = commandText;
  CLI::App* app = program.add_subcommand("promise",
    "Draw random scenes and judge by an integrator of its own whether they keep their tolerance");
  app->footer(
    "Prints a table of all kinds, and of each picture that breaks the promise the command\n"
    "that draws its scene alone. With --output it writes promise.md and promise.json.\n"
    "Examples:\n"
    "  varimarch-bench promise --scenes 500 --seed 1\n"
    "  varimarch-bench promise --only shadow-bands,soft --seed 7 --scenes 20 -o report");
  app->add_option("--scenes", arguments->options.scenes, "Number of scenes (default 200)")
    ->check(CLI::Range(1, 10000000).description(""))
    ->type_name("N");
  app
    ->add_option(
      "--seed", arguments->options.seed, "Seed of the first scene of each kind (default 1)")
    ->type_name("SEED");
  app->add_option("--only", arguments->options.only, "Kinds of scenes to draw (default all)")
    ->delimiter(',')
    ->check(OneOf(KindNames()));
  app
    ->add_option("--size", arguments->options.side,
      "Largest height and width of pictures (default: those of each kind)")
    ->check(CLI::Range(2, 1024).description(""))
    ->type_name("PIXELS");
  app->add_option("-o,--output", arguments->outputFolder, "The folder for the report")
    ->type_name("FOLDER");
  AddJsonOption(*app, arguments->jsonPath);
  app->callback([arguments] { Run(*arguments); });
}

}
