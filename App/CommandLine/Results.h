#ifndef Varimarch_CommandLine_Results_h
#define Varimarch_CommandLine_Results_h

#include "Scene/Model/Scene.h"
#include "Scene/Volumes/VolumeLoading.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace varimarch
{

/// The part of the results that all subcommands share: the command and the volume.
nlohmann::ordered_json ResultsOf(const std::string& commandText, const LoadedVolume& volume);

/// Writes results as JSON; does nothing for an empty path.
void WriteResults(const nlohmann::ordered_json& results, const std::string& path);

/// Formats a number with this many digits after the decimal point, for tables.
std::string Fixed(double number, int digits);

/// Formats three numbers in their shortest form.
std::string Triple(const double numbers[3], const std::string& separator);

}

#endif
