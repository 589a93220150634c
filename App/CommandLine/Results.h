#ifndef Varimarch_CommandLine_Results_h
#define Varimarch_CommandLine_Results_h

#include "Scene/Scene.h"
#include "Scene/VolumeLoading.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace varimarch
{

/// The part of every subcommand's results that tells how they came about.
nlohmann::ordered_json ResultsOf(const std::string& commandText, const LoadedVolume& volume);

/// Writes results as JSON; does nothing when the user asked for no file.
void WriteResults(const nlohmann::ordered_json& results, const std::string& path);

/// A number with so many digits behind the point, for tables.
std::string Fixed(double number, int digits);

/// Three numbers, separated by `separator`, as short as they can be.
std::string Triple(const double numbers[3], const std::string& separator);

}

#endif
