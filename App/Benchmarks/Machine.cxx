#include "Machine.h"

#include "CommandLine/Results.h"

#include <vtkVersion.h>

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iomanip>
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

std::string Now()
{
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::ostringstream text;
  text << std::put_time(std::gmtime(&now), "%Y-%m-%dT%H:%M:%SZ");
  return text.str();
}

}

Machine ThisMachine()
{
  double load = 0.0;
  getloadavg(&load, 1);
  return { ProcessorName(), std::thread::hardware_concurrency(), load, vtkVersion::GetVTKVersion(),
    Now() };
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

nlohmann::ordered_json ToJson(const Machine& machine)
{
  return { { "processor", machine.processor }, { "cores", machine.cores },
    { "loadBefore", machine.load }, { "vtkVersion", machine.vtkVersion },
    { "date", machine.date } };
}

std::string TextOf(const Machine& machine)
{
  return machine.processor + ", " + std::to_string(machine.cores) + " cores, VTK " +
    machine.vtkVersion + ", " + machine.date + ", load before the start " + Fixed(machine.load, 1);
}

}
