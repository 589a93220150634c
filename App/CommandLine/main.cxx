#include "Commands.h"
#include "Scene/OutputFile.h"
#include "VtkMessages.h"

#include <exception>
#include <iostream>
#include <new>

namespace
{

enum ExitCode
{
  Success = 0,
  Failure = 1,
  BadUsage = 2,
};

// The command as one could give it to a shell again.
std::string CommandText(int argc, char** argv)
{
  const std::string safe =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  std::string text = "varimarch";
  for (int i = 1; i < argc; ++i)
  {
    std::string word = argv[i];
    if (word.empty() || word.find_first_not_of(safe) != std::string::npos)
    {
      for (std::size_t at = 0; (at = word.find('\'', at)) != std::string::npos; at += 4)
      {
        word.replace(at, 1, "'\\''");
      }
      word = "'" + word + "'";
    }
    text += ' ';
    text += word;
  }
  return text;
}

int Run(int argc, char** argv)
{
  CLI::App program(
    "Draws medical volumes with the variation-field ray marcher, without a display.");
  program.name("varimarch");
  program.require_subcommand(1);
  program.set_version_flag(
    "--version", "varimarch " VARIMARCH_VERSION, "Print the version and exit");
  program.footer("varimarch SUBCOMMAND --help tells more, with examples.\n"
                 "Exit codes: 0 success, 1 failure, 2 bad usage.");
  const std::string commandText = CommandText(argc, argv);
  varimarch::AddRenderCommand(program, commandText);
  varimarch::AddCompareCommand(program, commandText);
  varimarch::AddBenchCommand(program, commandText);
  varimarch::AddInfoCommand(program, commandText);
  try
  {
    program.parse(argc, argv);
    return Success;
  }
  catch (const CLI::ParseError& error)
  {
    // CLI11 answers --help by this way too, with 0.
    return program.exit(error) == 0 ? Success : BadUsage;
  }
}

}

int main(int argc, char** argv)
{
  varimarch::RemoveUnfinishedFileOnInterrupt();
  varimarch::CollectVtkMessages();
  try
  {
    return Run(argc, argv);
  }
  catch (const std::bad_alloc&)
  {
    std::cerr << "varimarch: there is not enough memory\n";
  }
  catch (const std::exception& error)
  {
    std::cerr << "varimarch: " << error.what() << "\n";
  }
  return Failure;
}
