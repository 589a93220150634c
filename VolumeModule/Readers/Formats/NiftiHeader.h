#ifndef Varimarch_Readers_Formats_NiftiHeader_h
#define Varimarch_Readers_Formats_NiftiHeader_h

#include "Readers/Rescale.h"

#include <cstddef>
#include <cstdint>
#include <string>

// The C structs of NIfTI's headers and the codes of its data types. Both libraries below publish
// the definitions of the standard: vtk-dicom, which exists for Debian's VTK, and nifticlib, which
// needs no VTK.
#if __has_include("vtkNIFTIPrivate.h")
#include "vtkNIFTIPrivate.h"
#else
#include <nifti/nifti1.h>
#include <nifti/nifti2.h>
#endif

namespace varimarch
{

enum class NiftiKind
{
  OneFile, ///< the voxels follow the header
  Pair,    ///< the voxels are in a file of their own
  Analyze  ///< Analyze 7.5, a pair too, whose header has no mark and no orientation
};

/// The content of all versions of the header, in host byte order.
struct NiftiHeader
{
  NiftiKind kind;
  std::size_t byteCount; ///< size of the header with the flags of its extensions
  bool bigEndian;
  std::int64_t dim[8]; ///< [0] is the number of dimensions that follow
  int intent;
  int datatype;
  double pixdim[8]; ///< [0] is the sign of the third axis in the quaternion form
  double voxelOffset;
  bool padsEachVolume; ///< true if as many bytes as the offset come before each volume
  Rescale rescale;
  double calibration[2]; ///< smallest and largest value to show
  double timeOffset;     ///< time of the first volume, in the unit of time
  int units;
  int quaternionCode;
  int affineCode;
  double quaternion[3];
  double quaternionOffset[3];
  double affine[3][4]; ///< rows of the affine matrix
  /// For Analyze: the voxel at the origin as SPM stores it, counted from 1; 0 if not stated.
  double spmOrigin[3];
};

/// Reads the header of a file that may be compressed.
/// @throws std::runtime_error if it has none
NiftiHeader ReadNiftiHeader(const std::string& path);

}

#endif
