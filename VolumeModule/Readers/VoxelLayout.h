#ifndef Varimarch_Readers_VoxelLayout_h
#define Varimarch_Readers_VoxelLayout_h

#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <string>

class vtkImageData;

namespace varimarch
{

/// How many values of which type a header promises.
struct VoxelLayout
{
  std::array<std::int64_t, 3> dimensions; ///< voxels along each axis, x fastest
  int scalarType;                         ///< VTK_SHORT and the like
  std::int64_t componentCount = 1;        ///< values per voxel
};

/// Number of bytes the voxels take in memory.
/// @param path  for the error message
/// @throws std::runtime_error for dimensions that are not positive, more than four components, or
///   more bytes than this machine has memory
std::uint64_t CheckedByteCount(const std::string& path, const VoxelLayout& layout);

/// An image with room for the voxels, at the origin, with spacing 1. Check the layout first.
vtkSmartPointer<vtkImageData> AllocatedImage(const VoxelLayout& layout);

/// "512 x 512 x 134 voxels of short", for messages.
std::string Text(const VoxelLayout& layout);

/// "12.3 MB", for messages.
std::string ByteText(double bytes);

}

#endif
