#ifndef Varimarch_Viewer_DroppedFiles_h
#define Varimarch_Viewer_DroppedFiles_h

#include "Scene/VolumeLoading.h"

#include <string>
#include <vector>

namespace varimarch
{

/// Several files and folders that were dropped, or named, together: one scan, or series of DICOM to
/// choose from.
struct DroppedFiles
{
  std::string path; ///< the file or folder to open
  /// The DICOM files and folders whose series are meant; empty for a path that is meant as a whole.
  std::vector<std::string> ofSeries;
};

/// Finds out what was dropped. A header with its voxels is one volume, DICOM files and folders are
/// series below the folder that they share, and all images of a folder are a stack. Files of no
/// known format beside them, such as the notes on a disc, do not count.
/// @throws std::runtime_error if this is no single scan
DroppedFiles TogetherDropped(const std::vector<std::string>& paths);

/// The series to which the images of DICOM files and folders belong.
/// @throws std::runtime_error if the observer cancels
std::vector<SeriesSummary> SeriesOfFiles(const std::vector<SeriesSummary>& all,
  const std::vector<std::string>& paths, const LoadObserver& observe);

}

#endif
