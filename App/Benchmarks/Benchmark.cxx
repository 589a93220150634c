#include "Benchmark.h"

#include "CommandLine/OutputFolder.h"
#include "CommandLine/Parser.h"
#include "CommandLine/Results.h"
#include "Scene/Json/JsonCursor.h"

#include <vtkVersion.h>

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <thread>

namespace varimarch
{

namespace
{

std::string ProcessorName()
{
  std::ifstream file("/proc/cpuinfo");
  std::string line;
  while (std::getline(file, line))
  {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos)
    {
      return line.substr(colon + 2);
    }
  }
  return "not known";
}

// The date and time, ISO 8601, UTC.
std::string Now()
{
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::ostringstream text;
  text << std::put_time(std::gmtime(&now), "%Y-%m-%dT%H:%M:%SZ");
  return text.str();
}

// The machine on which times are measured, with its average load of the last minute.
nlohmann::ordered_json ThisMachine()
{
  double load = 0.0;
  getloadavg(&load, 1);
  return { { "processor", ProcessorName() }, { "cores", std::thread::hardware_concurrency() },
    { "loadBefore", load }, { "vtkVersion", vtkVersion::GetVTKVersion() }, { "date", Now() } };
}

std::vector<Benchmark> Benchmarks()
{
  std::vector<Benchmark> all = { WorkPrecisionBenchmark(), PublishedBenchmark(), SpeedBenchmark() };
  for (const Benchmark& benchmark : LightCostBenchmarks())
  {
    all.push_back(benchmark);
  }
  for (Benchmark (*make)() : { LightMethodsBenchmark, BesideBenchmark, ScalingBenchmark,
         FeatureBenchmark, ShaderBenchmark, ExtremesBenchmark, OrderBenchmark, ReferencesBenchmark,
         SoakBenchmark, TimesBenchmark, PromiseBenchmark })
  {
    all.push_back(make());
  }
  return all;
}

struct OutputOptions
{
  std::string folder;
  std::string copy;
};

void AddOutputOptions(CLI::App& command, BenchOutput output, OutputOptions& options)
{
  command.add_option("-o,--output", options.folder, "The folder for the results")
    ->type_name("FOLDER")
    ->required(output != BenchOutput::PrintedResults);
  if (output != BenchOutput::FilesOfOtherKind)
  {
    AddJsonOption(command, options.copy);
  }
}

void Add(CLI::App& program, const Benchmark& benchmark, const std::string& commandText)
{
  CLI::App* const command = program.add_subcommand(benchmark.name, benchmark.text);
  command->footer(benchmark.footer);
  benchmark.options(*command);
  const auto output = std::make_shared<OutputOptions>();
  AddOutputOptions(*command, benchmark.output, *output);
  command->callback(
    [=]
    {
      BenchResults results(benchmark.name, commandText, output->folder, output->copy);
      benchmark.run(results);
      if (benchmark.output != BenchOutput::FilesOfOtherKind)
      {
        results.Print();
      }
    });
}

}

BenchResults::BenchResults(const std::string& name, const std::string& commandText,
  const std::string& folder, const std::string& copy)
  : json({ { "benchmark", name }, { "command", commandText }, { "machine", ThisMachine() } })
  , name(name)
  , folder(folder.empty() ? std::filesystem::path() : OutputFolder(folder))
  , copy(copy)
{
  if (!this->folder.empty())
  {
    SetInterruptNotice(this->folder, "nothing yet");
  }
}

void BenchResults::Write(const std::string& contents) const
{
  if (!this->folder.empty())
  {
    WriteResults(this->json, this->folder / (this->name + ".json"));
    SetInterruptNotice(this->folder, contents);
  }
  WriteResults(this->json, this->copy);
}

void BenchResults::Print() const
{
  if (!this->folder.empty())
  {
    std::cout << "Results: " << (this->folder / (this->name + ".json")).string() << "\n";
  }
  else if (this->copy.empty())
  {
    std::cout << TextFromJson(this->json);
  }
}

void AddBenchmarks(CLI::App& program, const std::string& commandText)
{
  for (const Benchmark& benchmark : Benchmarks())
  {
    Add(program, benchmark, commandText);
  }
}

void AddSceneArgument(CLI::App& command, std::string& input)
{
  command
    .add_option(
      "SCENE", input, "A scene file (.json), volume file, DICOM folder, or procedural:NAME[:XxYxZ]")
    ->required();
}

void AddRoundsOption(CLI::App& command, int& rounds)
{
  command.add_option("--rounds", rounds, "Number of measurements of each (default 3)")
    ->check(CLI::Range(1, 10000).description(""))
    ->type_name("N");
}

void AddLongestOption(CLI::App& command, double& seconds, const std::string& description)
{
  command.add_option("--longest", seconds, description)
    ->check(CLI::PositiveNumber.description(""))
    ->type_name("SECONDS");
}

void AddSideOption(CLI::App& command, int& side)
{
  command.add_option("--side", side, "Side of the square images (default 512)")
    ->check(CLI::Range(1, 4096).description(""))
    ->type_name("PIXELS");
}

double StatusNumber(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.compare(0, key.size() + 1, key + ":") == 0)
    {
      return std::stod(line.substr(key.size() + 1));
    }
  }
  return 0.0;
}

double ResidentMegabytes()
{
  return StatusNumber("VmRSS") / 1024.0;
}

}
