#include "Commands.h"

#include "Results.h"
#include "Scene/Volumes/ImageStatistics.h"
#include "VolumeText.h"

#include <nlohmann/json.hpp>

#include <iostream>

namespace varimarch
{

namespace
{

// The labels that the arguments name, otherwise the volume itself if its values are labels.
std::shared_ptr<const LabelMap> LabelsOf(
  const InfoArguments& arguments, const VolumeSource& source, const LoadedVolume& volume)
{
  if (arguments.labels.path.empty() && !volume.segments.empty())
  {
    return std::make_shared<LabelMap>(LabelMapOf(volume, arguments.volume.input, volume));
  }
  Scene scene;
  scene.volume = source;
  return LoadLabelsReporting(arguments.labels, volume, scene);
}

}

void RunInfo(const InfoArguments& arguments)
{
  const std::string& input = arguments.volume.input;
  const VolumeSource source = SourceOf(arguments.volume, input);
  const LoadedVolume volume = LoadVolumeReporting(source);
  const std::shared_ptr<const LabelMap> labels = LabelsOf(arguments, source, volume);
  const ImageStatistics statistics(volume.image);
  nlohmann::ordered_json results = ResultsOf(arguments.commandText, volume);
  results["volume"].update(VolumeJson(volume, statistics, arguments.bins));
  AddSegments(labels, results);
  WriteResults(results, arguments.jsonPath);
  std::cout << VolumeText(input, volume, statistics, arguments.bins)
            << (labels ? SegmentsText(*labels) : "");
}

}
