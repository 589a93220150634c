#ifndef Varimarch_CommandLine_LabelArguments_h
#define Varimarch_CommandLine_LabelArguments_h

#include "Scene/Segments/LabelMap.h"

#include <nlohmann/json_fwd.hpp>

#include <memory>
#include <string>

namespace varimarch
{

/// The description of labels on the command line.
struct LabelArguments
{
  std::string path;       ///< segmentation or label map; empty: the scene's
  std::string colorTable; ///< file with names and colours of labels; empty: those of the labels
};

/// The labels of a scene, with the segments as the arguments say; null without any. A volume that
/// is a segmentation itself is drawn by its own labels. Prints warnings.
/// @param scene  gets the labels
/// @throws std::runtime_error when a file cannot be read, or the labels do not fit the volume
std::shared_ptr<const LabelMap> LoadLabelsReporting(
  const LabelArguments& arguments, const LoadedVolume& volume, Scene& scene);

/// The labels of a volume of a scene. Prints warnings.
/// @param ofScene  gets the segments
/// @throws std::runtime_error when a file cannot be read, or the labels do not fit the volume
std::shared_ptr<LabelMap> LoadLabelsReporting(const LoadedVolume& volume, SceneLabels& ofScene);

/// A table of the segments: value, voxels, volume, colour and name of each.
std::string SegmentsText(const LabelMap& labels);

/// Adds the table to results; nothing without labels.
void AddSegments(const std::shared_ptr<const LabelMap>& labels, nlohmann::ordered_json& results);

}

#endif
