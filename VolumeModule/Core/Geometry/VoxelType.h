#ifndef Varimarch_Core_Geometry_VoxelType_h
#define Varimarch_Core_Geometry_VoxelType_h

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

}

#endif
