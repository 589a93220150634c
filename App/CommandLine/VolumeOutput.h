#ifndef Varimarch_CommandLine_VolumeOutput_h
#define Varimarch_CommandLine_VolumeOutput_h

#include "Scene/Volumes/VolumeLoading.h"
#include "Scene/Volumes/VolumeWriters/ZarrFolder.h"

#include <string>

namespace varimarch
{

/// The file that a subcommand writes a volume to.
struct VolumeOutput
{
  std::string path;
  bool overwrites = false; ///< true to replace an existing file
};

/// Rejects an output that cannot be written, before a volume is read for it.
/// @param argument  name of the argument, for the message
/// @throws UsageError when no writer has the file's extension
/// @throws std::runtime_error when the file may not be written
void CheckVolumeOutput(const VolumeOutput& output, const std::string& argument);

/// Writes a volume. Prints as warnings what the format does not hold.
/// @throws std::runtime_error when the file cannot be written
void WriteVolumeReporting(const LoadedVolume& volume, const VolumeOutput& output);

/// Writes a volume that may be larger than memory as OME-Zarr, in the same way.
void WriteChunkedReporting(const ZarrInput& input, const VolumeOutput& output);

}

#endif
