#ifndef Varimarch_Testing_PhantomLibraryFiles_h
#define Varimarch_Testing_PhantomLibraryFiles_h

#include "PhantomFiles.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

/// Files of formats whose libraries write them: libtiff, netCDF, HDF5, blosc and VTK.

/// Variations of a TIFF file.
struct TiffOptions
{
  std::string description = {}; ///< ImageDescription of the first page
  int samples = 1;              ///< values per pixel
  bool isPlanar = false;
  bool isTiled = false;
  int compression = 1; ///< COMPRESSION_NONE; 5 is LZW, 8 is deflate
  bool bigEndian = false;
  bool isBig = false;               ///< true: BigTIFF
  double pixelsPerCentimetre = 0.0; ///< 0: no resolution
  int orientation = 1;
};

/// Writes a page for each slice; the values of a pixel follow each other in the volume's values.
void WriteTiff(
  const std::string& path, const StoredVolume& volume, const TiffOptions& options = {});

/// Writes a slice of a volume of bytes as PNG, JPEG or grey BMP, by the extension.
void WritePicture(const std::string& path, const StoredVolume& volume, int slice);

/// Variations of a MINC file.
struct MincOptions
{
  bool isScaled = false; ///< true: extremes of each slice, which make real values of stored ones
  /// Number of volumes, each with stored values 100 above those before; 0: no dimension of time.
  int timeCount = 0;
  bool hasOddMinima = false; ///< true: the smallest values vary along an axis more than the largest
  double timeStepSeconds = 0.0; ///< 0: not stated
};

void WriteMinc1(
  const std::string& path, const StoredVolume& volume, const MincOptions& options = {});
void WriteMinc2(
  const std::string& path, const StoredVolume& volume, const MincOptions& options = {});

/// The contents of a file of HDF5.
enum class Hdf5Kind
{
  DataSet,
  BigDataViewer,
  Imaris
};

/// Writes a volume of shorts in chunks, with the size of a voxel where the kind has it.
void WriteHdf5(const std::string& path, const StoredVolume& volume, Hdf5Kind kind);

/// Voxels of shorts in chunks, some of which are not stored.
struct SparseVolume
{
  std::array<int, 3> size; ///< voxels along x, y and z
  std::array<int, 3> chunk;
  int fill; ///< the value of voxels that are not stored
  std::vector<short> voxels;
  std::function<bool(const std::array<int, 3>& chunk)> isStored;
};

/// Writes a data set of HDF5 whose file lacks chunks.
void WriteSparseHdf5(const std::string& path, const SparseVolume& volume);

/// The description of an array of Zarr version 2 in one chunk, of shorts or else of unsigned ints.
/// @param compressor  its entry in JSON
std::string ZarrArrayText(const StoredVolume& volume, const std::string& compressor);

/// The metadata of OME-Zarr for one level in the folder 0, with axes along those of the world.
std::string OmeZarrText(const StoredVolume& volume);

/// Bytes in a container of blosc, compressed by "zstd", "lz4" or another of its methods.
std::string Blosced(const std::string& bytes, const std::string& method);

/// The real value of a stored value of a scaled MINC file.
double MincReal(double stored, int slice);

#endif
