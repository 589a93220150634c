#ifndef Varimarch_Scene_LabelMap_h
#define Varimarch_Scene_LabelMap_h

#include "Scene/Scene.h"
#include "Scene/Segments.h"
#include "Scene/VolumeLoading.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace varimarch
{

/// The labels of a scan as plain data: a segmentation or label map on the grid of the scan, and its
/// segments. ScenePipeline draws it. It does not change: what a user edits are the segments of the
/// scene, SceneLabels, which begin as a copy of these.
struct LabelMap
{
  /// The segment of each voxel of the scan, as unsigned char: 0 in none, i + 1 in segments[i].
  vtkSmartPointer<vtkImageData> image;
  std::vector<Segment> segments;
  std::vector<SegmentSize> sizes;    ///< size of each segment on the grid of the scan
  std::vector<std::string> warnings; ///< one sentence each
};

/// True if each voxel of the labels lies where the scan has the voxel of the same index.
bool AreOnGridOf(vtkImageData* labels, vtkImageData* scan);

/// Puts labels on the grid of a scan, by the nearest voxel.
/// @param labels  a volume whose values are labels, whether its file says so or not
/// @param path    its file, for messages
/// @throws std::runtime_error with one sentence if the values are not labels, or do not belong to
///         the scan: other frame of reference, no overlap
LabelMap LabelMapOf(const LoadedVolume& labels, const std::string& path, const LoadedVolume& scan);

/// Reads the labels of a scene, and gives their segments the appearance that the scene says.
/// @throws std::runtime_error as LoadVolume and LabelMapOf do
LabelMap LoadLabels(
  const SceneLabels& labels, const LoadedVolume& scan, const LoadObserver& observer = {});

/// Gives segments the appearance that a scene says. Warns of those that the labels do not have.
/// @param path  file of the labels, for messages
void TakeAppearance(const std::vector<Segment>& ofScene, const std::string& path, LabelMap& map);

/// A look that draws nothing but labels, for a segmentation without its scan.
Look LookOfLabelsOnly();

}

#endif
