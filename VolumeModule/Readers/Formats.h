#ifndef Varimarch_Readers_Formats_h
#define Varimarch_Readers_Formats_h

#include "Readers/VolumeFile.h"

#include <string>
#include <vector>

namespace varimarch
{

/// A file format: a row of the table in Formats.cxx. To add a format, write its Read function in
/// its own file, declare it here, and add a row.
struct VolumeFormat
{
  const char* name;
  const char* description;             ///< text for a file dialog
  std::vector<std::string> extensions; ///< lower case, with the dot
  /// True if the first bytes of a file (at most 512) may be of this format; null for formats
  /// without a signature.
  bool (*recognises)(const std::string& head);
  /// Reads a file. Throws std::runtime_error with the sentence of FailToRead, or ReadCancelled.
  Volume (*read)(const std::string& path, const ReadOptions& options, ReadProgress& progress);
};

const std::vector<VolumeFormat>& VolumeFormats();

/// The format of a file, by its extension or else its first bytes; a folder is DICOM. A file of
/// unknown format is raw voxels if the options give dimensions. Null if no format matches.
const VolumeFormat* FormatOfFile(const std::string& path, const ReadOptions& options);

/// True if the file exists, has a known format, and begins as that format does.
bool LooksReadable(const std::string& path);

/// Reads a file or folder of any format.
/// @throws std::runtime_error with one sentence about what was expected and what was found
/// @throws ReadCancelled
Volume ReadVolume(const std::string& path, const ReadOptions& options, ReadProgress& progress);

Volume ReadDicom(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadInv3(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadMetaImage(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadNifti(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadNrrd(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadRaw(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadVti(const std::string& path, const ReadOptions& options, ReadProgress& progress);

}

#endif
