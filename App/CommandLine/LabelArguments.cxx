#include "LabelArguments.h"

#include "Messages.h"
#include "Progress.h"
#include "Results.h"
#include "Scene/Segments/Segments.h"
#include "UsageError.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace varimarch
{

namespace
{

/// A colour such as "#ff8000".
std::string HexText(const glm::dvec3& rgb)
{
  std::ostringstream text;
  text << '#' << std::hex << std::setfill('0');
  for (int channel = 0; channel < 3; ++channel)
  {
    text << std::setw(2) << std::lround(255.0 * rgb[channel]);
  }
  return text.str();
}

void ChooseLabels(const LabelArguments& arguments, const LoadedVolume& volume, Scene& scene)
{
  const auto* const file = std::get_if<FileSource>(&scene.volume);
  if (!arguments.path.empty())
  {
    scene.labels = SceneLabels{ arguments.path };
  }
  else if (!scene.labels && !volume.segments.empty() && file)
  {
    PrintMessage("warning: the volume is a segmentation and is drawn without its scan; to draw it "
                 "over the scan: render SCAN --labels " +
      file->path);
    scene.labels = SceneLabels{ file->path, file->series };
  }
}

// A segmentation without its scan has had its warnings already.
void PrintNewWarnings(const LabelMap& labels, const LoadedVolume& volume)
{
  for (const std::string& warning : labels.warnings)
  {
    const auto& known = volume.warnings;
    if (std::find(known.begin(), known.end(), warning) == known.end())
    {
      PrintMessage("warning: " + warning);
    }
  }
}

}

std::shared_ptr<const LabelMap> LoadLabelsReporting(
  const LabelArguments& arguments, const LoadedVolume& volume, Scene& scene)
{
  ChooseLabels(arguments, volume, scene);
  if (!scene.labels)
  {
    if (!arguments.colorTable.empty())
    {
      throw UsageError(
        "--label-colors: expected --labels FILE or a scene with labels, found neither");
    }
    return nullptr;
  }
  auto labels = LoadLabelsReporting(volume, *scene.labels);
  if (!arguments.colorTable.empty())
  {
    TakeTable(ReadSegmentTable(arguments.colorTable), labels->segments);
    scene.labels->segments = labels->segments;
  }
  return labels;
}

std::shared_ptr<LabelMap> LoadLabelsReporting(const LoadedVolume& volume, SceneLabels& ofScene)
{
  const Progress progress("Reading " + ofScene.path);
  auto labels = std::make_shared<LabelMap>(LoadLabels(ofScene, volume));
  PrintNewWarnings(*labels, volume);
  ofScene.segments = labels->segments;
  return labels;
}

std::string SegmentsText(const LabelMap& labels)
{
  std::ostringstream text;
  text << "segments     (value, voxels, volume in ml, colour, name)\n";
  for (std::size_t i = 0; i < labels.segments.size(); ++i)
  {
    const Segment& segment = labels.segments[i];
    const SegmentSize& size = labels.sizes[i];
    text << std::setw(12) << segment.value << std::setw(12) << size.voxels << std::setw(12)
         << Fixed(size.volumeMl, 2) << "  " << HexText(segment.rgb) << "  " << segment.name << "\n";
  }
  return text.str();
}

void AddSegments(const std::shared_ptr<const LabelMap>& labels, nlohmann::ordered_json& results)
{
  for (std::size_t i = 0; labels && i < labels->segments.size(); ++i)
  {
    const Segment& segment = labels->segments[i];
    results["segments"].push_back({ { "value", segment.value }, { "name", segment.name },
      { "color", { segment.rgb.r, segment.rgb.g, segment.rgb.b } },
      { "voxels", labels->sizes[i].voxels }, { "volumeMl", labels->sizes[i].volumeMl } });
  }
}

}
