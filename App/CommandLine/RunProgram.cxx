#include "Messages.h"
#include "Parser.h"
#include "ReportedErrors.h"
#include "Scene/Files/OutputFile.h"
#include "UsageError.h"

#include <CLI/CLI.hpp>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>

namespace varimarch
{

namespace
{

enum ExitCode
{
  Success = 0,
  Failure = 1,
  BadUsage = 2,
};

// The command line, quoted so that a shell accepts it.
std::string CommandText(int argc, char** argv)
{
  const std::string safe =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  std::string text = ProgramName();
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

// Fails if what was printed is lost, such as on a full disk.
void CheckStandardOutput()
{
  errno = 0;
  if (!std::cout.flush())
  {
    throw std::runtime_error(std::string("standard output: cannot be written") +
      (errno == 0 ? "" : std::string(": ") + std::strerror(errno)));
  }
}

int Parse(CLI::App& program, int argc, char** argv)
{
  try
  {
    program.parse(argc, argv);
    return Success;
  }
  catch (const CLI::ParseError& error)
  {
    // --help arrives here too, with exit code 0.
    return program.exit(error) == 0 ? Success : BadUsage;
  }
  catch (const UsageError& error)
  {
    program.exit(CLI::ValidationError(error.what()));
    return BadUsage;
  }
}

}

int RunProgram(const std::string& summary, const std::string& version,
  SubcommandAdder addSubcommands, int argc, char** argv)
{
  DeleteUnfinishedFileOnSignals(ProgramName());
  // A file beyond the shell's limit is then an error of the writer.
  std::signal(SIGXFSZ, SIG_IGN);
  CollectVtkMessages();
  const std::string name = ProgramName();
  try
  {
    CLI::App program(summary);
    program.name(name);
    program.require_subcommand(1);
    program.set_version_flag("--version", name + " " + version, "Print the version and exit");
    program.footer(name +
      " SUBCOMMAND --help describes a subcommand, with examples.\n"
      "Exit codes: 0 success, 1 failure, 2 bad usage.");
    addSubcommands(program, CommandText(argc, argv));
    const int result = Parse(program, argc, argv);
    CheckStandardOutput();
    return result;
  }
  catch (const std::bad_alloc&)
  {
    PrintMessage("not enough memory; close other programs or use a smaller volume or image");
  }
  catch (const std::exception& error)
  {
    PrintMessage(error.what());
  }
  return Failure;
}

}
