#ifndef Varimarch_Testing_PhantomFiles_h
#define Varimarch_Testing_PhantomFiles_h

#include <vtkType.h>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

/// A volume as stored in a file, with its position in LPS [mm].
struct StoredVolume
{
  std::array<int, 3> dimensions;
  std::vector<double> values; ///< x fastest
  int scalarType = VTK_SHORT;
  glm::dvec3 originMm = glm::dvec3(0.0);
  glm::dmat3 axesMm = glm::dmat3(1.0); ///< column a is the step along axis a
};

/// A box of 5 x 4 x 3 voxels of different values and sizes at an oblique angle. Any flip, swap or
/// wrong scale of its axes is detectable.
namespace phantom
{
constexpr std::array<int, 3> dimensions = { 5, 4, 3 };
constexpr int orientationCount = 48;

/// Value of the voxel with this index in the phantom itself.
double ValueAt(const glm::ivec3& index);

/// Fractional index of a position in the phantom itself.
glm::dvec3 IndexAt(const glm::dvec3& worldMm);

/// The phantom stored with its axes in one of the 6 orders, each forwards or backwards.
/// @param orientation  0 <= orientation < 48
StoredVolume Stored(int orientation);
}

/// A folder that is deleted at the end of the test.
class TemporaryFolder
{
public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  void operator=(const TemporaryFolder&) = delete;

  std::string Path(const std::string& name) const { return (this->path / name).string(); }
  /// Writes a file and returns its path.
  std::string Write(const std::string& name, const std::string& bytes) const;
  /// The bytes of a file of the folder.
  std::string Bytes(const std::string& name) const;

private:
  std::filesystem::path path;
};

/// The voxels as bytes of their type.
std::string VoxelBytes(const StoredVolume& volume, bool bigEndian = false);
/// The voxels as decimal numbers.
std::string VoxelText(const StoredVolume& volume);

std::string Gzipped(const std::string& bytes);
std::string Zlibbed(const std::string& bytes);

/// A file, or a symbolic link, in an archive.
struct ArchiveEntry
{
  std::string path;
  std::string bytes;
  std::string linkTarget = {}; ///< not empty for a link
};
/// An archive by libarchive: "zip", "pax", "gnutar" ..., compressed by "gzip", "bzip2" ... or not.
std::string Archived(const std::vector<ArchiveEntry>& entries, const std::string& format,
  const std::string& filter = "");
/// Bytes compressed by libarchive: "gzip", "bzip2", "xz" or "zstd".
std::string Compressed(const std::string& bytes, const std::string& filter);

/// Files of each format, written according to its specification, without any library.
std::string NrrdHeaderText(const StoredVolume& volume, const std::string& space = "LPS");
std::string MetaImageHeaderText(const StoredVolume& volume);
std::string VtiText(const StoredVolume& volume, const std::array<int, 3>& firstIndex = { 0, 0, 0 });
/// A VTI file with the values in cells, whose centres are the positions of the voxels.
std::string VtiCellText(const StoredVolume& volume);

/// Encoding of a VTI file by VTK's own writer: values of vtkXMLWriter.
struct VtiEncoding
{
  int dataMode; ///< vtkXMLWriter::Ascii, Binary, Appended
  bool base64 = true;
  int compressor = 0; ///< vtkXMLWriter::NONE, ...
  bool bigEndian = false;
  int headerBits = 32;
};
/// A VTI file of VTK's own writer with these bytes as voxels.
std::string EncodedVti(
  const StoredVolume& volume, const std::string& voxelBytes, const VtiEncoding& encoding);

enum class NiftiForm
{
  Affine,
  Quaternion
};
std::string NiftiBytes(
  const StoredVolume& volume, NiftiForm form = NiftiForm::Affine, bool bigEndian = false);
/// Sets a field of a header in this machine's byte order.
template <class Value>
void Put(std::string& bytes, std::size_t offset, Value value)
{
  std::memcpy(bytes.data() + offset, &value, sizeof(value));
}
/// The header of an Analyze 7.5 pair, as SPM99 writes it.
/// @param spmOrigin  the voxel at the origin, counted from 1; 0 if not stated
std::string AnalyzeHeaderBytes(const StoredVolume& volume,
  const std::array<int, 3>& spmOrigin = { 0, 0, 0 }, bool bigEndian = false);
/// The file .mat that SPM99 writes beside such a pair.
std::string SpmMatrixBytes(const StoredVolume& volume);
/// NIfTI-2 with the affine form.
std::string Nifti2Bytes(const StoredVolume& volume, bool bigEndian = false);

/// Variations of a DICOM slice.
struct DicomOptions
{
  std::string seriesUid = "1.2.3";
  double slope = 1.0;
  double intercept = 0.0;
  int rows = 0;                 ///< rows in the header; 0: the true number
  int instance = 0;             ///< distinguishes images of the same slice
  std::string position = {};    ///< position in the header; empty: the true one
  bool lossy = false;           ///< true: the header reports lossy compression
  std::string description = {}; ///< series description
  std::string modality = "CT";
  std::string contrastAgent = {};
  std::string bodyPart = {};
  bool isAngiography = false;
  double repetitionMs = 0.0; ///< 0: absent
  double echoMs = 0.0;
};
/// A slice of a volume of shorts, uncompressed, little-endian.
std::string DicomBytes(const StoredVolume& volume, int slice, const DicomOptions& options = {});
/// A DICOMDIR: an index of the images of one series.
/// @param imageNames  relative to the folder of the index, with backslashes between their parts
std::string DicomIndexBytes(const std::vector<std::string>& imageNames);

#endif
