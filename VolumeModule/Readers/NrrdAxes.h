#ifndef Varimarch_Readers_NrrdAxes_h
#define Varimarch_Readers_NrrdAxes_h

#include "Readers/NrrdHeader.h"
#include "Readers/VolumeFile.h"
#include "Readers/VoxelLayout.h"

#include <cstdint>
#include <string>
#include <vector>

namespace varimarch
{

/// The role of each axis of an NRRD file.
struct NrrdAxes
{
  std::vector<std::int64_t> sizes;
  std::vector<std::size_t> spatial; ///< at most three axes of the volume, fastest first
  std::int64_t volumeCount = 1;     ///< number of time points or list elements
  std::vector<std::size_t> lists;   ///< axes of these volumes, fastest first
  bool areAlternating = false;      ///< the volumes alternate voxel by voxel, instead of one by one
  std::int64_t componentCount = 1;  ///< values per voxel
  bool planar = false;     ///< components are stored one after another, each for the whole volume
  bool areComplex = false; ///< the components are a real and an imaginary part
};

/// Determines the axes.
/// @throws std::runtime_error for axes that do not form a volume
NrrdAxes AxesOf(const NrrdHeader& header);

/// The times of the volumes: in seconds if the header has their distance with its unit, or if they
/// are those of a 3D Slicer's multi-volume.
VolumeTimes TimesOf(const NrrdHeader& header, const NrrdAxes& axes);

/// @throws std::runtime_error for an unknown scalar type
VoxelLayout LayoutOf(const NrrdHeader& header, const NrrdAxes& axes);

}

#endif
