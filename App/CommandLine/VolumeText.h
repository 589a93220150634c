#ifndef Varimarch_CommandLine_VolumeText_h
#define Varimarch_CommandLine_VolumeText_h

#include "Scene/Volumes/ImageStatistics.h"
#include "Scene/Volumes/VolumeLoading.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace varimarch
{

/// The description of a volume that `varimarch info` prints.
/// @param name  the file, folder or procedural volume
/// @param bins  number of bars of the histogram, >= 1
std::string VolumeText(
  const std::string& name, const LoadedVolume& volume, const ImageStatistics& statistics, int bins);

/// The description as JSON, without the results of ResultsOf.
nlohmann::ordered_json VolumeJson(
  const LoadedVolume& volume, const ImageStatistics& statistics, int bins);

}

#endif
