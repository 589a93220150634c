#include "Commands.h"

#include "Results.h"
#include "Scene/ImageStatistics.h"
#include "VolumeText.h"

#include <nlohmann/json.hpp>

#include <iostream>

namespace varimarch
{

void RunInfo(const InfoArguments& arguments)
{
  const std::string& input = arguments.volume.input;
  const LoadedVolume volume = LoadVolumeReporting(SourceOf(arguments.volume, input));
  const ImageStatistics statistics(volume.image);
  nlohmann::ordered_json results = ResultsOf(arguments.commandText, volume);
  results["volume"].update(VolumeJson(volume, statistics, arguments.bins));
  WriteResults(results, arguments.jsonPath);
  std::cout << VolumeText(input, volume, statistics, arguments.bins);
}

}
