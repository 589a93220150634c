#ifndef Varimarch_Resources_GapTextures_h
#define Varimarch_Resources_GapTextures_h

#include "Core/Fields/GapField.h"
#include "Frame/VolumeGeometry.h"
#include "Resources/VolumeTexture.h"

#include <glm/vec3.hpp>

class vtkUnsignedCharArray;

namespace varimarch
{

/// What of a volume is left out, beside voxels that are not finite: points and cells whose ghost
/// flags say anything, as vtkUniformGrid::BlankPoint and duplicates between processes have it. A
/// point takes the cells around it away, as vtkUniformGrid::IsCellVisible has it.
struct Blanking
{
  vtkUnsignedCharArray* points = nullptr; ///< none: no flags, or none that says anything
  vtkUnsignedCharArray* cells = nullptr;
  glm::ivec3 pointCount = glm::ivec3(0);
  VoxelPlace place = VoxelPlace::Points; ///< what the voxels are
  bool nearest = false;                  ///< voxels are boxes of one value

  bool Any() const { return this->points || this->cells; }

  /// Whether gaps are of voxels as boxes, not of the cells between them.
  bool IsOfVoxels() const;

  bool operator==(const Blanking& other) const
  {
    return this->points == other.points && this->cells == other.cells &&
      this->pointCount == other.pointCount && this->place == other.place &&
      this->nearest == other.nearest;
  }
};

/// The gaps of a region of a volume.
GapField GapFieldOf(const ScalarRegion& region, const Blanking& blanking);

}

#endif
