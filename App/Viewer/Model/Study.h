#ifndef Varimarch_Viewer_Study_h
#define Varimarch_Viewer_Study_h

#include "Scene/Measures/RegionStatistics.h"
#include "Scene/Pipeline/SceneOverlays.h"
#include "Scene/Segments/LabelMap.h"
#include "Scene/Segments/SegmentEditing.h"
#include "Scene/Volumes/ImageStatistics.h"
#include "Scene/Volumes/VolumeLoading.h"

#include <memory>
#include <mutex>
#include <vector>

namespace varimarch
{

/// Guards the voxels of a volume's labels, which the window's thread writes while others copy them.
struct LabelGuard
{
  std::mutex mutex; ///< held while voxels are written or copied, and for the count
  int writes = 0;   ///< how often voxels have been written
};

/// A volume in memory with the statistics of its voxels, and the labels over it. It does not
/// change, but SceneModel and SegmentEditor edit the voxels of the labels where they are.
struct Study
{
  LoadedVolume volume;
  ImageStatistics statistics; ///< counts of the volume at the time when it was opened
  std::shared_ptr<const LabelMap> labels = {}; ///< null without a segmentation
  int labelVersion = 0; ///< a number for the voxels of the labels, see SceneModel::LabelVersion
  std::vector<RegionStatistics>
    segmentStatistics = {}; ///< the volume in each segment of the labels
  /// False if these statistics, and the sizes of the segments, are those of earlier voxels.
  bool areSegmentsCounted = true;
  /// The same for all studies of a volume, whatever its time and its labels.
  std::shared_ptr<LabelGuard> labelGuard = std::make_shared<LabelGuard>();
  /// The volumes over this one, in the order of the scene's overlays.
  std::vector<std::shared_ptr<const Study>> overlays = {};
  /// Counts of all times of the volume; null until they have been read, and for a single time.
  std::shared_ptr<const ImageStatistics> allTimes = {};
};

/// The same study at another time of its volume, which has the same size. Segments are not counted
/// anew.
std::shared_ptr<const Study> AtTime(const Study& scan, const LoadedVolume& ofTime);

/// True if a volume over the first one has as many times, which then follow those of the first. So
/// does the first one itself.
bool FollowsTimes(const Study& first, const Study& over);

/// Another form of a volume, with the overlays of that volume.
std::shared_ptr<const Study> WithOverlaysOf(
  const Study& scan, const std::shared_ptr<const Study>& form);

/// The voxels of the overlays, as ScenePipeline::SetOverlays takes them.
std::vector<OverlayVoxels> VoxelsOfOverlays(const Study& study);

/// The study of a volume: 0 is the first, i the overlay i - 1.
const Study& StudyOfVolume(const Study& first, int volume);

/// The same volumes with another study of one of them.
std::shared_ptr<const Study> WithVolume(
  const Study& first, int volume, std::shared_ptr<const Study> changed);

/// The same volume with other labels.
std::shared_ptr<const Study> WithLabels(const Study& scan, LabelMap labels);

/// The first of several volumes that labels fit, with the labels. A volume with their grid comes
/// before all others.
/// @throws std::runtime_error as LabelMapOf does if they fit none
std::shared_ptr<const Study> WithLabelsOnOne(std::vector<std::shared_ptr<const Study>> scans,
  const LoadedVolume& labels, const std::string& path);

/// The same volume with the sizes and statistics of the segments as they are.
/// @param image    as SharedCopy returns it, in another thread than the window's
std::shared_ptr<const Study> WithCounts(const Study& study, vtkImageData* image);

/// A copy of a volume for another thread, which shares the voxels. VTK keeps what it finds out
/// about an array with the array, so each thread has arrays of its own, except for voxels in a
/// file, which are known by their array.
vtkSmartPointer<vtkImageData> SharedCopy(const LoadedVolume& volume);

/// Writes a change into the numbers of labels, or takes it back.
void WriteLabels(
  const LabelChange& change, bool isForward, vtkImageData* numbers, LabelGuard& guard);

/// How often the numbers of the labels have been written.
int WritesOfLabels(const Study& study);

/// A copy of the numbers of the labels, which the window's thread may write meanwhile. Segments
/// that the study does not have yet are left out.
vtkSmartPointer<vtkImageData> CopyOfLabels(const Study& study);

/// The same volume without labels.
std::shared_ptr<const Study> WithoutLabels(const Study& scan);

}

#endif
