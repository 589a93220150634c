#ifndef Varimarch_Scene_VolumeLoading_h
#define Varimarch_Scene_VolumeLoading_h

#include "Scene/Model/Scene.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;

namespace varimarch
{

/// Grey pixels, row by row from the upper left.
struct GrayPicture
{
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;
};

/// The middle slice of a volume in storage order, rows downwards. The 1st percentile is black, the
/// 99th white.
GrayPicture MiddleSlice(vtkImageData* image);

/// Arrangement of a scan's slices. Tilted, unevenly spaced or missing slices are irregular.
enum class SliceLayout
{
  Even,
  Irregular, ///< as stored; the source can ask to resample them
  Rectified, ///< were irregular and have been resampled on an even grid
};

/// The times of a file, one of which is in memory.
struct LoadedTimes
{
  std::vector<double> values = { 0.0 }; ///< at least one, in ascending order
  bool areSeconds = false;              ///< otherwise numbers, counted from 0
  int current = 0;                      ///< the time in memory, counted from 0

  bool AreSeveral() const { return this->values.size() > 1; }
};

struct LoadedVolume
{
  vtkSmartPointer<vtkImageData> image; ///< world space is LPS [mm]
  std::string modality;                ///< as in DICOM: "CT", "MR"; empty if unknown
  std::vector<std::string> warnings;   ///< one sentence each
  SliceLayout slices = SliceLayout::Even;
  std::string bodyPart = {};     ///< as in DICOM: "HEAD"; empty if unknown
  bool hasContrastAgent = false; ///< true if the file says so
  std::string weighting = {};    ///< for MR: "T1", "T2", "angiography"; empty if unknown
  /// Width and middle of the range of values that the file recommends for slices; empty if it
  /// recommends none.
  std::optional<std::array<double, 2>> windowLevel = {};
  bool isInverted = false; ///< true if slices are meant with their smallest values white
  /// All segments if the values are labels: those that the file describes, and the other values.
  /// Otherwise empty.
  std::vector<Segment> segments = {};
  double uptakeValueFactor = 0.0;    ///< for PET: from values to SUV [g/ml]; 0 if unknown
  std::string frameOfReference = {}; ///< UID of DICOM for the space of the image; may be empty
  bool isOnDisk = false;  ///< true if the voxels stayed in their file, because they are so many
  bool isPreview = false; ///< true for a coarse copy, of which the warnings tell
  LoadedTimes times = {};
  /// Names of the kinds of volume that a DICOM series holds, such as "echo 20"; one of them was
  /// read.
  std::vector<std::string> kinds = {};
};

/// Receives the fraction of the work done, [0, 1]; returns false to cancel.
using LoadObserver = std::function<bool(double)>;

/// Reads or computes the volume of a scene. Procedural volumes report no progress.
/// @param mayBePreview  true to get a coarse copy of a volume that takes long to be opened for the
/// first time
/// @throws std::runtime_error with one sentence that names the file and the fault, or reports that
///   the observer cancelled
LoadedVolume LoadVolume(
  const VolumeSource& source, const LoadObserver& observer = {}, bool mayBePreview = false);

/// Reads one time after the other of a file with several, and finds and unpacks nothing again. The
/// file must not change meanwhile. All of it is used in one thread at a time.
class TimeReader
{
public:
  explicit TimeReader(const FileSource& source);
  ~TimeReader();
  TimeReader(const TimeReader&) = delete;
  TimeReader& operator=(const TimeReader&) = delete;

  /// @param time  counted from 0; the time of the source is not used
  /// @throws std::runtime_error as LoadVolume does
  LoadedVolume Read(int time, const LoadObserver& observer);

private:
  struct State;

  std::unique_ptr<State> state;
};

/// One DICOM series of a folder or disc.
struct SeriesSummary
{
  std::string uid;
  std::string description; ///< as entered at the scanner; may be empty
  std::string modality;    ///< "CT", "MR" ...
  std::int64_t imageCount;
  GrayPicture middle;                ///< the middle image; empty if it cannot be read
  std::string frameOfReference = {}; ///< as in LoadedVolume
};

/// True if a source may hold several series: a folder, an archive, or the index file of a disc.
bool MayHoldSeveralSeries(const FileSource& source);

/// Reads the labels of a scene as a volume of its own; those of a folder are its first
/// segmentation.
/// @throws std::runtime_error as LoadVolume does
LoadedVolume LoadLabelVolume(const SceneLabels& labels, const LoadObserver& observer = {});

/// Lists the series in a folder and its subfolders, or those of an index file, the largest first.
/// @throws std::runtime_error as LoadVolume does
std::vector<SeriesSummary> ListSeries(const std::string& path, const LoadObserver& observer = {});

/// A reduced copy of a volume, at the same place in the world, with at most `largestSide` voxels
/// along each axis. Each voxel is the mean of those that it replaces. The copy shares no data with
/// the volume and reads only its voxels.
vtkSmartPointer<vtkImageData> SmallCopy(vtkImageData* image, int largestSide);

}

#endif
