#ifndef Varimarch_Benchmarks_Benchmark_h
#define Varimarch_Benchmarks_Benchmark_h

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace varimarch
{

/// The files that a benchmark writes.
enum class BenchOutput
{
  Results,         ///< NAME.json in the folder of --output, and a copy at --json
  PrintedResults,  ///< the same, or JSON on the standard output without a folder
  FilesOfOtherKind ///< no results
};

/// The results of a benchmark: one JSON file, from which App/Benchmarks/Report makes tables and
/// plots.
class BenchResults
{
public:
  nlohmann::ordered_json json; ///< begins with the command and the machine before the start

  /// @param folder  empty: the results are printed at the end
  /// @param copy  another file for the results; empty: none
  BenchResults(const std::string& name, const std::string& commandText, const std::string& folder,
    const std::string& copy);

  /// The folder for the results and for images. It exists.
  const std::filesystem::path& Folder() const { return this->folder; }

  /// Writes what is known so far, so that an interrupted run keeps its results.
  /// @param contents  the results so far in words, for the message after an interrupt
  void Write(const std::string& contents) const;

  /// Prints where the results are, or the results if there is no folder.
  void Print() const;

private:
  std::string name;
  std::filesystem::path folder;
  std::string copy;
};

/// A subcommand of varimarch-bench.
struct Benchmark
{
  std::string name;
  std::string text;                       ///< a sentence for the list of subcommands
  std::string footer;                     ///< the end of its help, with examples
  std::function<void(CLI::App&)> options; ///< adds its options
  std::function<void(BenchResults&)> run; ///< measures with the values of its options
  BenchOutput output = BenchOutput::Results;
};

/// A benchmark whose options fill a struct.
template <class Options>
Benchmark MakeBenchmark(const std::string& name, const std::string& text, const std::string& footer,
  void (*addOptions)(CLI::App&, Options&), void (*run)(const Options&, BenchResults&),
  const Options& defaults = {})
{
  const auto options = std::make_shared<Options>(defaults);
  return { name, text, footer, [=](CLI::App& command) { addOptions(command, *options); },
    [=](BenchResults& results) { run(*options, results); } };
}

// The benchmarks, each in a file of its own.
Benchmark WorkPrecisionBenchmark();
Benchmark PublishedBenchmark();
Benchmark SpeedBenchmark();
std::vector<Benchmark> LightCostBenchmarks();
Benchmark LightMethodsBenchmark();
Benchmark BesideBenchmark();
Benchmark ScalingBenchmark();
Benchmark FeatureBenchmark();
Benchmark ShaderBenchmark();
Benchmark ExtremesBenchmark();
Benchmark OrderBenchmark();
Benchmark ReferencesBenchmark();
Benchmark SoakBenchmark();
Benchmark TimesBenchmark();
Benchmark PromiseBenchmark();

/// Adds a subcommand for each of them.
void AddBenchmarks(CLI::App& program, const std::string& commandText);

/// Adds the argument SCENE.
void AddSceneArgument(CLI::App& command, std::string& input);

/// Adds --rounds, with a default of 3.
void AddRoundsOption(CLI::App& command, int& rounds);

/// Adds --longest.
void AddLongestOption(CLI::App& command, double& seconds, const std::string& description);

/// Adds --side, with a default of 512.
void AddSideOption(CLI::App& command, int& side);

/// A number after a key of /proc/self/status, such as "Threads".
double StatusNumber(const std::string& key);

/// The memory of this process that is resident [MB].
double ResidentMegabytes();

}

#endif
