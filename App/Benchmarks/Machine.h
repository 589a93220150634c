#ifndef Varimarch_Benchmarks_Machine_h
#define Varimarch_Benchmarks_Machine_h

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace varimarch
{

/// What a measured time depends on, for reports.
struct Machine
{
  std::string processor; ///< the CPU's own name
  unsigned cores;
  double load; ///< processes that wanted a core in the minute before, see getloadavg
  std::string vtkVersion;
  std::string date; ///< day and time, ISO 8601, UTC
};

/// This one, now.
Machine ThisMachine();

nlohmann::ordered_json ToJson(const Machine& machine);

}

#endif
