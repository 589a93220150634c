#ifndef Varimarch_Frame_VoxelInput_h
#define Varimarch_Frame_VoxelInput_h

#include "Core/Geometry/UnevenAxis.h"
#include "Frame/VolumeGeometry.h"

#include "vtkType.h"

#include <glm/vec3.hpp>

#include <tuple>
#include <vector>

class vtkDataArray;
class vtkUnsignedCharArray;

namespace varimarch
{

/// A component of the voxels, stored as a component of an array.
struct VoxelComponent
{
  vtkDataArray* array; ///< One tuple for each voxel, x fastest.
  int index;           ///< The component of the array.
};

inline auto FieldsOf(const VoxelComponent& component)
{
  const auto& [array, index] = component;
  return std::tie(array, index);
}

inline bool operator==(const VoxelComponent& one, const VoxelComponent& other)
{
  return FieldsOf(one) == FieldsOf(other);
}

/// The components of a volume, one to four.
using VoxelComponents = std::vector<VoxelComponent>;

/// A mask. Its voxels span the same box as those of the volume.
struct MaskVoxels
{
  vtkDataArray* labels = nullptr; ///< An array of one component.
  glm::ivec3 dimensions = glm::ivec3(0);
  vtkMTimeType time = 0; ///< The time of the last change of the labels.
  bool binary = false;   ///< True if labels only switch voxels on and off.
  std::vector<int> rows; ///< The labels with functions of their own, ascending; empty if binary.
};

inline auto FieldsOf(const MaskVoxels& mask)
{
  const auto& [labels, dimensions, time, binary, rows] = mask;
  return std::tie(labels, dimensions, time, binary, rows);
}

inline bool operator==(const MaskVoxels& one, const MaskVoxels& other)
{
  return FieldsOf(one) == FieldsOf(other);
}

/// The points and cells that ghost flags remove from a volume: those set by
/// vtkUniformGrid::BlankPoint, and duplicates between processes. A blanked point also removes the
/// cells around it, as in vtkUniformGrid::IsCellVisible.
struct Blanking
{
  vtkUnsignedCharArray* points = nullptr; ///< The flags of points; null if no flag is set.
  vtkUnsignedCharArray* cells = nullptr;  ///< The flags of cells; null if no flag is set.
  glm::ivec3 pointCount = glm::ivec3(0);
  VoxelPlace place = VoxelPlace::Points; ///< The elements that have the volume's values.
  bool nearest = false;                  ///< True if voxels are not interpolated.

  bool Any() const { return this->points || this->cells; }

  /// True if gaps are whole voxels, false if they are the cells between voxels.
  bool IsOfVoxels() const
  {
    const bool ofPoints = this->place == VoxelPlace::Points;
    return ofPoints ? this->nearest && !this->cells : this->nearest || this->Any();
  }
};

inline auto FieldsOf(const Blanking& blanking)
{
  const auto& [points, cells, pointCount, place, nearest] = blanking;
  return std::tie(points, cells, pointCount, place, nearest);
}

inline bool operator==(const Blanking& one, const Blanking& other)
{
  return FieldsOf(one) == FieldsOf(other);
}

/// The voxels that a frame shows. The arrays belong to the caller's pipeline.
struct VoxelInput
{
  vtkDataArray* scalars = nullptr;
  VoxelComponents components;   ///< The components that are drawn, possibly of two arrays.
  vtkMTimeType time = 0;        ///< The time of the last change of the input.
  std::vector<UnevenAxis> axes; ///< The axes of a rectilinear grid; empty for an image.
  Blanking blanking;
  MaskVoxels mask; ///< Empty unless the settings have a mask.
};

}

#endif
