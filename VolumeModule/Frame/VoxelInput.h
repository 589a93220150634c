#ifndef Varimarch_Frame_VoxelInput_h
#define Varimarch_Frame_VoxelInput_h

#include "Core/Geometry/UnevenAxis.h"
#include "Frame/VolumeGeometry.h"

#include "vtkType.h"

#include <glm/vec3.hpp>

#include <vector>

class vtkDataArray;
class vtkUnsignedCharArray;

namespace varimarch
{

/// One of the numbers that each voxel has: a component of an array.
struct VoxelComponent
{
  vtkDataArray* array; ///< One tuple for each voxel, x fastest.
  int index;           ///< The component of the array.

  bool operator==(const VoxelComponent& other) const
  {
    return this->array == other.array && this->index == other.index;
  }
};

/// The components of a volume, one to four.
using VoxelComponents = std::vector<VoxelComponent>;

/// A mask. Its voxels span the same box as those of the volume.
struct MaskVoxels
{
  vtkDataArray* labels = nullptr; ///< An array of one component.
  glm::ivec3 dimensions = glm::ivec3(0);
  vtkMTimeType time = 0; ///< The time of the last change of the labels.
  bool binary = false;   ///< True if a label only says whether a voxel is drawn.
  std::vector<int> rows; ///< The labels with functions of their own, sorted; none if binary.

  bool operator==(const MaskVoxels& other) const
  {
    return this->labels == other.labels && this->time == other.time &&
      this->binary == other.binary && this->rows == other.rows;
  }
};

/// The points and cells that ghost flags leave out of a volume, as vtkUniformGrid::BlankPoint sets
/// them and duplicates between processes have them. A blanked point takes the cells around it away,
/// as in vtkUniformGrid::IsCellVisible.
struct Blanking
{
  vtkUnsignedCharArray* points = nullptr; ///< Null where no point is flagged.
  vtkUnsignedCharArray* cells = nullptr;  ///< Null where no cell is flagged.
  glm::ivec3 pointCount = glm::ivec3(0);
  VoxelPlace place = VoxelPlace::Points; ///< The kind of the volume's voxels.
  bool nearest = false;                  ///< True if voxels are boxes of one value.

  bool Any() const { return this->points || this->cells; }

  /// True if gaps are voxels as boxes, not the cells between voxels.
  bool IsOfVoxels() const
  {
    const bool ofPoints = this->place == VoxelPlace::Points;
    return ofPoints ? this->nearest && !this->cells : this->nearest || this->Any();
  }

  bool operator==(const Blanking& other) const
  {
    return this->points == other.points && this->cells == other.cells &&
      this->pointCount == other.pointCount && this->place == other.place &&
      this->nearest == other.nearest;
  }
};

/// The voxels that a frame shows. The arrays belong to the caller's pipeline.
struct VoxelInput
{
  vtkDataArray* scalars = nullptr;
  VoxelComponents components; ///< The numbers that are drawn; also a second array's, if asked for.
  vtkMTimeType time = 0;      ///< The time of the last change of the input.
  std::vector<UnevenAxis> axes; ///< The axes of a rectilinear grid; none for an image.
  Blanking blanking;
  MaskVoxels mask; ///< Empty unless the settings have a mask.
};

}

#endif
