#ifndef Varimarch_Readers_VoxelLayout_h
#define Varimarch_Readers_VoxelLayout_h

#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <string>

class vtkImageData;

namespace varimarch
{

/// Number and type of the values that a header promises.
struct VoxelLayout
{
  std::array<std::int64_t, 3> dimensions; ///< voxels along each axis, x fastest
  int scalarType;                         ///< VTK_SHORT or another VTK type
  std::int64_t componentCount = 1;        ///< values per voxel
};

/// Memory that the voxels need [bytes].
/// @param path  path for the error message
/// @throws std::runtime_error for dimensions below 1, no component, or more bytes than the
/// machine's memory
std::uint64_t CheckedByteCount(const std::string& path, const VoxelLayout& layout);

/// An image with memory for the voxels, at the origin, with spacing 1. The layout must have been
/// checked.
vtkSmartPointer<vtkImageData> AllocatedImage(const VoxelLayout& layout);

/// A text such as "512 x 512 x 134 voxels of short", for messages.
std::string Text(const VoxelLayout& layout);

/// A text such as "12.3 MB", for messages.
std::string ByteText(double bytes);

}

#endif
