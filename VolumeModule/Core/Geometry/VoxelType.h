#ifndef Varimarch_Core_Geometry_VoxelType_h
#define Varimarch_Core_Geometry_VoxelType_h

#include <cstdint>

namespace varimarch
{

/// The types of voxels that packets of rays can read where they are.
enum class VoxelType
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Float32,
};

/// Calls a function with a voxel of this type. It has a copy in each file, because some files are
/// compiled for processors that others must do without.
/// @param call  (voxel)
template <class Call>
static auto ByVoxelType(VoxelType type, Call call)
{
  switch (type)
  {
    case VoxelType::Int8:
      return call(std::int8_t());
    case VoxelType::UInt8:
      return call(std::uint8_t());
    case VoxelType::Int16:
      return call(std::int16_t());
    case VoxelType::UInt16:
      return call(std::uint16_t());
    case VoxelType::Float32:
      break;
  }
  return call(float());
}

}

#endif
