#ifndef Varimarch_Readers_NrrdAxes_h
#define Varimarch_Readers_NrrdAxes_h

#include "Readers/ImageGeometry.h"
#include "Readers/NrrdHeader.h"
#include "Readers/VoxelLayout.h"

#include <cstdint>
#include <string>
#include <vector>

namespace varimarch
{

/// Which of the axes of an NRRD file are those of the volume, and what the others are.
struct NrrdAxes
{
  std::vector<std::int64_t> sizes;
  std::vector<std::size_t> spatial; ///< at most three, fastest first
  std::int64_t volumeCount = 1;     ///< time points or a list
  std::int64_t componentCount = 1;  ///< values per voxel
  bool planar = false;              ///< the components lie one volume after another
};

/// Adds to the warnings when only the first of several volumes is taken.
/// @throws std::runtime_error for axes that are no volume
NrrdAxes AxesOf(const NrrdHeader& header, std::vector<std::string>& warnings);

/// @throws std::runtime_error for a type that is not known
VoxelLayout LayoutOf(const NrrdHeader& header, const NrrdAxes& axes);

/// Adds to the warnings when the file does not say how the patient lies.
/// @throws std::runtime_error for a space or for numbers that make none
ImageGeometry GeometryOf(
  const NrrdHeader& header, const NrrdAxes& axes, std::vector<std::string>& warnings);

}

#endif
