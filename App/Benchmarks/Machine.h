#ifndef Varimarch_Benchmarks_Machine_h
#define Varimarch_Benchmarks_Machine_h

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace varimarch
{

/// The machine on which times were measured, for reports.
struct Machine
{
  std::string processor; ///< name of the CPU
  unsigned cores;
  double load; ///< average load of the last minute, see getloadavg
  std::string vtkVersion;
  std::string date; ///< date and time, ISO 8601, UTC
};

/// Describes this machine, with its load at the time of the call.
Machine ThisMachine();

/// Number after a key of /proc/self/status, such as "Threads".
double StatusNumber(const std::string& key);

/// Memory of this process that is resident [MB].
double ResidentMegabytes();

nlohmann::ordered_json ToJson(const Machine& machine);

/// The same as a part of a sentence.
std::string TextOf(const Machine& machine);

}

#endif
