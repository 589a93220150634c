#ifndef Varimarch_Readers_Packed_KeptInput_h
#define Varimarch_Readers_Packed_KeptInput_h

#include "Readers/Dicom/DicomSeries.h"
#include "Readers/Packed/ByteStream.h"
#include "Readers/Packed/Unpacked.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// Copies of a packed path; null for a folder that can be read as it is.
struct KeptCopies
{
  std::unique_ptr<Unpacked> copies;
  std::vector<std::string> warnings; ///< sentences about what was left out
};

/// The memory of a reader from one time of a path to the next, so that it finds and unpacks nothing
/// again. The path must not change meanwhile.
struct KeptInput
{
  KeptStream stream;

  /// Copies of packed paths, by these: one in another has copies of its own.
  std::map<std::string, KeptCopies> copies;

  /// The series below the path; null until they are found.
  std::unique_ptr<const DicomScan> scan;

  /// The time from one volume to the next, in formats that have it behind the voxels; null until it
  /// is read, 0 if the file does not say it.
  std::optional<double> repetitionSeconds;

  /// Size of the first of several files that are times.
  std::optional<std::array<int, 3>> sizeOfFiles;
};

/// The kept stream of options; null if nothing is kept.
inline KeptStream* StreamOf(const ReadOptions& options)
{
  return options.kept ? &options.kept->stream : nullptr;
}

}

#endif
