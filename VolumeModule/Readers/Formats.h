#ifndef Varimarch_Readers_Formats_h
#define Varimarch_Readers_Formats_h

#include "Readers/VolumeFile.h"

#include <string>
#include <vector>

namespace varimarch
{

/// A file format: a row of the table in Formats.cxx. To add one, write its Read function in a file
/// of its own, declare it here, and add a row.
struct VolumeFormat
{
  const char* name;
  const char* description;             ///< for a file dialog
  std::vector<std::string> extensions; ///< lower case, with the dot
  /// Whether the first bytes of a file (up to 512) may be of this format; null for one without
  /// marks.
  bool (*recognises)(const std::string& head);
  /// Reads a file. Throws std::runtime_error with the one sentence of FailToRead, or ReadCancelled.
  Volume (*read)(const std::string& path, const ReadOptions& options, ReadProgress& progress);
};

const std::vector<VolumeFormat>& VolumeFormats();

/// The format of a file: by its extension, else by its first bytes; a folder is DICOM. A file of
/// unknown kind is bare voxels if the options say how many. Null if nothing fits.
const VolumeFormat* FormatOfFile(const std::string& path, const ReadOptions& options);

/// Whether the file exists, is of a known format, and begins as that format does.
bool LooksReadable(const std::string& path);

/// Reads a file or folder of any format.
/// @throws std::runtime_error with one sentence that says what was expected and what was found
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
