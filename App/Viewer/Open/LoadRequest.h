#ifndef Varimarch_Viewer_LoadRequest_h
#define Varimarch_Viewer_LoadRequest_h

#include "Viewer/Model/Study.h"

#include <QString>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace varimarch
{

/// A scan in place of the one that is shown.
struct NewScan
{
  VolumeSource source;
  /// Digest of the DICOM series (DigestOfSeries); empty to take the only one, or to ask the user.
  QString digest = {};
  std::vector<SeriesSummary> segmentations = {}; ///< known to lie beside the series
};

/// Files and folders that are one scan together: a header with its voxels is one volume, DICOM
/// files and folders are series below the folder that they share, and all images of a folder are a
/// stack. Files of no known format beside them, such as the notes on a disc, do not count.
struct ScanOfFiles
{
  std::vector<std::string> paths;
};

/// A saved scene with its scan.
struct SavedSession
{
  Scene scene;
  bool isAutosaved = false;                      ///< the copy of a program that was interrupted
  std::vector<SeriesSummary> segmentations = {}; ///< as for NewScan
};

/// A scan to be drawn over the one that is shown.
struct AddedScan
{
  VolumeSource source;
};

/// The scan that is shown in another form: rectified, or as scanned.
struct OtherForm
{
  VolumeSource source;
  std::optional<SceneLabels> labels;
};

/// Labels over a volume that is shown.
struct LabelsOverScan
{
  SceneLabels labels;
  int volume; ///< number of the volume
  std::shared_ptr<const Study> scan;
};

/// A file that may be a segmentation of one of several volumes that are shown, or else is a new
/// scan.
struct DroppedFile
{
  std::string path;
  int volume; ///< number of the first of the volumes
  /// The volumes. One with the grid of the file is taken, or else the first that the file fits.
  std::vector<std::shared_ptr<const Study>> scans;
};

/// A scan or labels to be loaded.
using LoadRequest = std::variant<NewScan, ScanOfFiles, SavedSession, AddedScan, OtherForm,
  LabelsOverScan, DroppedFile>;

/// The file or folder that a request names first; empty for a computed volume.
QString PathOf(const LoadRequest& request);

/// The data that were read for a request. A folder with several series has neither study. A file
/// that could be a segmentation, but does not say so, has both.
struct LoadResult
{
  VolumeSource source = {};
  std::shared_ptr<const Study> study = {};    ///< the volume, if one was read
  std::shared_ptr<const Study> labelled = {}; ///< a scan with labels over it, if they were read
  SceneLabels labels = {};
  std::vector<SeriesSummary> series = {}; ///< all series of a folder
};

/// The segmentations among the series of a folder.
std::vector<SeriesSummary> SegmentationsAmong(const std::vector<SeriesSummary>& series);

/// The same request for one of the series that were found.
LoadRequest WithSeries(const LoadRequest& request, const LoadResult& found, const std::string& uid);

/// Receives a coarse copy of a volume that takes long to be opened for the first time.
using ShowPreview = std::function<void(const VolumeSource&, std::shared_ptr<const Study>)>;

/// Reads what is requested. Labels and overlays that cannot be read are left out with a warning, as
/// they do not lose their volume. A segmentation that is opened as a scan gets its own labels.
/// @param show  called before a new scan without labels and overlays, if its first opening takes
///              long
/// @throws std::runtime_error as LoadVolume does, or if files are no single scan
LoadResult ReadRequest(
  const LoadRequest& request, const LoadObserver& observe, const ShowPreview& show);

}

#endif
