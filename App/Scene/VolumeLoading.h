#ifndef Varimarch_Scene_VolumeLoading_h
#define Varimarch_Scene_VolumeLoading_h

#include "Scene/Scene.h"
#include "Scene/SlicePixels.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>
#include <vector>

namespace varimarch
{

/// How the slices of a scan lie: tilted, at uneven distances or with some missing they are
/// irregular.
enum class SliceLayout
{
  Even,
  Irregular, ///< and would be resampled if the source asked for it
  Rectified, ///< they were irregular, and are resampled on an even grid
};

struct LoadedVolume
{
  vtkSmartPointer<vtkImageData> image; ///< world space is LPS [mm]
  std::string modality;                ///< as DICOM has it: "CT", "MR"; empty when not known
  std::vector<std::string> warnings;   ///< one sentence each
  SliceLayout slices = SliceLayout::Even;
  std::string bodyPart = {};     ///< as DICOM has it: "HEAD"; empty when not known
  bool hasContrastAgent = false; ///< the file says so
  std::string weighting = {};    ///< of MR: "T1", "T2", "angiography"; empty when not known
};

/// Told the part of the work that is done, [0, 1]; says whether to go on.
using LoadObserver = std::function<bool(double)>;

/// Reads or computes the volume of a scene. Procedural volumes know no progress.
/// @throws std::runtime_error with one sentence that names the file and what is wrong with it, or
///   says that the observer did not want to go on
LoadedVolume LoadVolume(const VolumeSource& source, const LoadObserver& observer = {});

/// One of the DICOM series at a place.
struct SeriesSummary
{
  std::string uid;
  std::string description; ///< as the scanner's operator named it, or empty
  std::string modality;    ///< "CT", "MR" ...
  std::int64_t imageCount;
  GrayPicture middle; ///< the image in its middle; empty when it cannot be read
};

/// Whether there may be several series: a folder, or the index file of a disc.
bool MayHoldSeveralSeries(const FileSource& source);

/// The series in a folder and the folders in it, or those of an index file; the largest first.
/// @throws std::runtime_error as LoadVolume does
std::vector<SeriesSummary> ListSeries(const std::string& path, const LoadObserver& observer = {});

}

#endif
