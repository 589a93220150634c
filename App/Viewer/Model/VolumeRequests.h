#ifndef Varimarch_Viewer_VolumeRequests_h
#define Varimarch_Viewer_VolumeRequests_h

#include "Viewer/Model/Study.h"

#include <QString>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// The result of a request. A folder with several series has neither study.
struct Found
{
  VolumeSource source;
  std::shared_ptr<const Study> study; ///< the volume, if one was read
  SceneLabels labels;
  std::shared_ptr<const Study> labelled;    ///< a scan with labels over it, if they were read
  std::vector<SeriesSummary> series;        ///< all series of a folder
  std::vector<SeriesSummary> segmentations; ///< the segmentations among them
};

/// A wish for a volume.
struct VolumeWish
{
  VolumeSource source;
  QString digest; ///< digest of the DICOM series; empty if there is a choice
  std::optional<SceneLabels> labels;
  std::vector<OverlaidVolume> overlays;
  bool isForItself = true; ///< False if a coarse copy of the volume is of no use.
  /// The DICOM files and folders whose series are meant; empty for all that the source holds.
  std::vector<std::string> ofSeries = {};
};

/// Receives a coarse copy of a volume that takes long to be opened for the first time.
using ShowPreview = std::function<void(const VolumeSource&, std::shared_ptr<const Study>)>;

/// Reads a volume, its labels and its overlays.
/// @param show  called in this thread before the volume itself is read, if it has neither
/// @throws std::runtime_error as LoadVolume does
Found ReadVolume(const VolumeWish& wish, const LoadObserver& observe, const ShowPreview& show);

/// Reads the scan that files and folders are together, see TogetherDropped.
/// @throws std::runtime_error as LoadVolume does, or if they are no single scan
Found ReadTogether(
  const std::vector<std::string>& paths, const LoadObserver& observe, const ShowPreview& show);

/// Reads a file that may be a segmentation of one of several scans, see VolumeLoader::LoadBeside.
/// @throws std::runtime_error as LoadVolume does
Found ReadBeside(const std::string& path, const std::vector<std::shared_ptr<const Study>>& scans,
  const LoadObserver& observe);

}

#endif
