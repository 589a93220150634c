#ifndef Varimarch_CommandLine_VolumeArguments_h
#define Varimarch_CommandLine_VolumeArguments_h

#include "Scene/Model/Scene.h"
#include "Scene/Volumes/VolumeLoading.h"

#include <optional>
#include <string>

namespace varimarch
{

/// The largest number of voxels along an axis that the command line accepts.
constexpr int LargestVolumeSide = 1 << 20;

/// The description of the volume on the command line.
struct VolumeArguments
{
  std::string input;
  bool rectify = false;       ///< true to resample tilted or unevenly spaced slices on an even grid
  bool asScanned = false;     ///< true to keep them
  std::string series;         ///< DICOM series to read; empty: the first
  int kind = 0;               ///< kind of volume in the series, from 1; 0: the first
  std::optional<int> level;   ///< level of a file with several; empty: the finest that fits
  std::optional<int> channel; ///< channel of such a file; empty: as in FileSource
  std::string time;           ///< number or seconds of the time to read; empty: the first
  bool filesAreTimes = false; ///< true if the files of a folder, or of one name, are times
  double memoryMegabytes = 0.0; ///< memory that the program may use [MB]; 0: the machine's
  RawLayout raw;                ///< layout of a raw file; dimensions of 0 if the file has a header
};

/// The file, folder or procedural volume that an input names.
/// @throws UsageError when the other arguments do not fit the input
VolumeSource SourceOf(const VolumeArguments& arguments, const std::string& input);

/// A sentence that says why a text is no time such as "3" or "1.4s"; empty if it is one.
std::string TimeProblem(const std::string& text);

/// Rejects a raw layout and a DICOM series for an input that describes its voxels itself.
/// @param kind  kind of the input, for the message
/// @throws UsageError when the arguments have one of them
void RejectFileArguments(const VolumeArguments& arguments, const std::string& kind);

/// The volume of a scene file, changed by the arguments that override it.
/// @throws UsageError when an argument does not fit the volume
VolumeSource Override(const VolumeArguments& arguments, const VolumeSource& volumeOfScene);

/// Reads a volume. Prints its warnings and, if it takes long, a progress line on stderr.
/// @param mayBePreview  see LoadVolume
/// @throws std::runtime_error when the file cannot be read
LoadedVolume LoadVolumeReporting(const VolumeSource& source, bool mayBePreview = false);

}

#endif
