#ifndef Varimarch_Testing_PhantomFormats_h
#define Varimarch_Testing_PhantomFormats_h

#include "PhantomFiles.h"

#include <string>
#include <vector>

/// Files of formats with few writers, written according to their descriptions, without any library.

/// An MGH file of version 1.
std::string MghBytes(const StoredVolume& volume);

/// The header of an AFNI file, whose voxels are in a file of the same name with .BRIK.
/// @param bigEndian  byte order of the voxels
std::string AfniHeaderText(const StoredVolume& volume, bool bigEndian = false);

/// The header of a MIF file, whose axes are stored in another order and direction.
/// @param places  for each axis of the header, its place in the file
/// @param isBackwards  for each axis of the header, true if it is stored backwards
std::string MifHeaderText(const StoredVolume& volume, const std::array<int, 3>& places,
  const std::array<bool, 3>& isBackwards);

/// A GIPL file, which has no directions.
std::string GiplBytes(const StoredVolume& volume);

/// An MRC file, whose axes are along those of the world [angstrom].
std::string MrcBytes(const StoredVolume& volume, bool bigEndian = false);

/// A NumPy file.
/// @param shape  as in Python, slowest index first
std::string NpyBytes(const StoredVolume& volume, const std::vector<int>& shape,
  bool isFortran = false, bool bigEndian = false);

/// An SLC file of bytes.
std::string SlcBytes(const StoredVolume& volume, bool isEncoded);

/// A PVM file of bytes or of 16 bits.
std::string PvmBytes(const StoredVolume& volume);

/// Bytes in the compression of PVM files.
/// @param planes  number of planes into which bytes are separated, 1 to 4
/// @param rowBytes  distance of the second byte that predicts a byte, 1 to 65536
std::string DdsBytes(const std::string& bytes, int planes, int rowBytes);

/// The header of a Philips PAR file of a volume whose slices are transverse and not turned.
/// @param slices  for each line of the list, its slice from 0; the voxel file has this order
/// @param stepSeconds  time from one volume to the next
std::string ParText(
  const StoredVolume& volume, const std::vector<int>& slices, double stepSeconds = 0.0);

#endif
