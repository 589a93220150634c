#ifndef Varimarch_Scene_LabelMap_h
#define Varimarch_Scene_LabelMap_h

#include "Scene/Model/Scene.h"
#include "Scene/Segments/Segments.h"
#include "Scene/Volumes/VolumeLoading.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkVolumeProperty;

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

// Drawing of segments by the label map masks of VTK's mappers. A visible segment has one colour and
// one opacity, whatever the values of the scan. The rest is drawn as the look says.

/// Gives each segment of a label map its functions.
/// @param property  has the functions of a look
/// @param segments  as many as the labels have, in their order
void ApplySegments(
  const LabelMap& labels, const std::vector<Segment>& segments, vtkVolumeProperty* property);

/// Gives a volume of its own, whose values are the numbers of the segments and whose voxels are
/// boxes, the colours and opacities of the visible ones, where a mapper has no masks.
void ApplySegmentsByNumber(
  const LabelMap& labels, const std::vector<Segment>& segments, vtkVolumeProperty* property);

/// The mask of a mapper for labels, without what scissors remove.
/// @param kept  as MaskOf in SceneCuts.h returns it; may be null
vtkSmartPointer<vtkImageData> LabelMask(const LabelMap& labels, vtkImageData* kept);

/// Refuses to replace a file of a scan.
/// @throws std::runtime_error with one sentence if the path is the file of a scan, or an existing
///         file in the folder of one
void RequireNoFileOf(const std::vector<VolumeSource>& scans, const std::string& path);

/// Writes the segments of a scan as a label map on its grid: a ".seg.nrrd" of 3D Slicer with names
/// and colours, or NIfTI (".nii", ".nii.gz") with the values alone.
/// @param segments  of the labels, with the names and colours to write
/// @param scans     sources of the volume and of those over it, whose files are never replaced
/// @return sentences about what the format does not hold
/// @throws std::runtime_error with one sentence for another extension, for the file of a scan, or
/// if
///         the file cannot be written
std::vector<std::string> WriteSegments(const LabelMap& labels, const std::vector<Segment>& segments,
  const std::vector<VolumeSource>& scans, const std::string& path);

}

#endif
