#ifndef Varimarch_Readers_VoxelLayout_h
#define Varimarch_Readers_VoxelLayout_h

#include "Core/Geometry/VoxelType.h"

#include <vtkSmartPointer.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

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

bool IsSame(const VoxelLayout& one, const VoxelLayout& other);

/// The index of the first layout of the kind that most are of; there must be at least one.
std::size_t MostFrequent(const std::vector<VoxelLayout>& layouts);

enum class NumberKind
{
  Signed,
  Unsigned,
  Float
};

/// The VTK type of numbers of this kind and size; VTK_VOID if there is none.
int ScalarTypeOf(NumberKind kind, std::int64_t byteCount);

/// True for a VTK type of numbers.
bool IsNumberType(int scalarType);

/// The type in which packets of rays read voxels of a VTK type; none if they cannot.
std::optional<VoxelType> VoxelTypeOf(int scalarType);

/// Size of the voxels [bytes].
/// @param path  path for the error message
/// @throws std::runtime_error for dimensions below 1, no component, or more bytes than files have
std::uint64_t ByteCountOf(const std::string& path, const VoxelLayout& layout);

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

struct ReadOptions;

/// Main memory of the machine [bytes].
double PhysicalMemoryBytes();

/// Memory that a reader's options let the program use [bytes].
std::uint64_t MostMemoryBytes(const ReadOptions& options);

/// Main memory that programs may still take [bytes].
double FreeMemoryBytes();

}

#endif
