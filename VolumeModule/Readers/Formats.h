#ifndef Varimarch_Readers_Formats_h
#define Varimarch_Readers_Formats_h

#include "Readers/VolumeFile.h"

#include <functional>
#include <string>
#include <vector>

namespace varimarch
{

/// The subject of the files of a format.
enum class Subject
{
  Anything,
  PatientIfSidesAreKnown, ///< a patient if a file says which side is the left
  Patient,
};

/// A file format: a row of the table in Formats.cxx. To add a format, write its Read function in
/// its own file, declare it here, and add a row.
struct VolumeFormat
{
  const char* name;
  const char* description;             ///< text for a file dialog
  std::vector<std::string> extensions; ///< lower case, with the dot
  /// True for the first bytes (at most 4096, decompressed) of a file of this format; null for
  /// formats without a signature, whose files are known by their extensions.
  std::function<bool(const std::string& head)> recognises;
  /// Reads a file. Throws std::runtime_error with the sentence of FailToRead, or ReadCancelled.
  Volume (*read)(const std::string& path, const ReadOptions& options, ReadProgress& progress);
  /// True if a folder is a volume of this format; null for formats of single files.
  bool (*recognisesFolder)(const std::string& path) = nullptr;
  /// True if the reader decompresses files itself, so that only the first of several volumes needs
  /// to be; false if compressed files are unpacked before.
  bool decompresses = false;
  Subject subject = Subject::Anything;
};

const std::vector<VolumeFormat>& VolumeFormats();

/// The format of a file or folder by its content or, for formats without a signature, by its name.
/// A file of unknown format is raw voxels if the options give dimensions. Null if no format
/// matches.
/// @throws std::runtime_error if the file cannot be read
const VolumeFormat* FormatOfFile(const std::string& path, const ReadOptions& options);

/// The format of a file in a folder, by its content only; null also if the file cannot be read.
const VolumeFormat* FormatOfMember(const std::string& path);

/// FormatOfFile, but null if the file cannot be read.
const VolumeFormat* FormatIfReadable(const std::string& path);

/// True if FormatIfReadable finds a format; true for every folder.
bool LooksReadable(const std::string& path);

/// Reads a file or folder of any format.
/// @throws std::runtime_error with one sentence about what was expected and what was found
/// @throws ReadCancelled
Volume ReadVolume(const std::string& path, const ReadOptions& options, ReadProgress& progress);

/// The same, but irregular slices stay as they are even if the options say otherwise.
Volume ReadUnrectified(const std::string& path, const ReadOptions& options, ReadProgress& progress);

/// Reads one of several files that are times: those of a folder, or those beside a file whose names
/// differ from its own in the last number before the first dot only. Their order is that of the
/// numbers in their names.
/// @throws std::runtime_error also if their sizes differ
Volume ReadFilesAsTimes(
  const std::string& path, const ReadOptions& options, ReadProgress& progress);

/// True for the first bytes, decompressed, of a file of the format.
bool IsAfni(const std::string& head);
bool IsGipl(const std::string& head);
bool IsHdf5(const std::string& head);
bool IsMgh(const std::string& head);
bool IsMif(const std::string& head);
bool IsMinc(const std::string& head);
bool IsMrc(const std::string& head);
bool IsNifti(const std::string& head);
bool IsNpy(const std::string& head);
bool IsPar(const std::string& head);
bool IsPvm(const std::string& head);
bool IsSlc(const std::string& head);
bool IsStackSlice(const std::string& head);
bool IsTiff(const std::string& head);
bool IsZarr(const std::string& head);

/// The property list of an InVesalius project.
constexpr const char* InVesaliusFile = "main.plist";

/// True for a folder with DICOM files, with an InVesalius project, with pictures and no other
/// volumes, with files of other formats, or of Zarr.
bool HoldsDicom(const std::string& folder);
bool HoldsInv3(const std::string& folder);
bool HoldsPictures(const std::string& folder);
bool HoldsVolumes(const std::string& folder);
bool HoldsZarr(const std::string& folder);

Volume ReadAfni(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadDicom(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadGipl(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadHdf5(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadImageStack(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadInv3(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadLegacyVtk(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadMetaImage(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadMgh(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadMif(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadMinc(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadMrc(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadNifti(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadNpy(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadNrrd(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadPacked(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadParRec(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadPvm(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadPvti(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadRaw(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadSlc(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadTiff(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadVti(const std::string& path, const ReadOptions& options, ReadProgress& progress);
Volume ReadZarr(const std::string& path, const ReadOptions& options, ReadProgress& progress);

}

#endif
