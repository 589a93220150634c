#ifndef Varimarch_Viewer_WholeSeries_h
#define Varimarch_Viewer_WholeSeries_h

#include "Viewer/Model/BackgroundTask.h"

#include <optional>
#include <string>

namespace varimarch
{

/// The DICOM series that an image belongs to, with the images beside it.
struct WholeSeries
{
  std::string folder;
  std::string uid;
  int imageCount; ///< at least two
};

/// Looks for the other images of a file's series in its folder. Empty if there are none, or if the
/// file is no DICOM image.
std::optional<WholeSeries> WholeSeriesOf(const std::string& path, const TaskProgress& goesOn);

}

#endif
