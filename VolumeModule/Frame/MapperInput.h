#ifndef Varimarch_Frame_MapperInput_h
#define Varimarch_Frame_MapperInput_h

#include "Core/Geometry/UnevenAxis.h"
#include "Frame/VolumeGeometry.h"

#include <optional>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkVolumeMapper;

namespace varimarch
{

/// What a mapper has as input.
struct MapperInput
{
  vtkDataSet* data; ///< an image or a rectilinear grid
  vtkDataArray* scalars;
  VoxelPlace place; ///< of the scalars

  glm::ivec3 PointCount() const;

  VolumeGeometry Geometry(vtkVolume* volume, const std::vector<UnevenAxis>& axes) const;

  /// Of a rectilinear grid; none of an image.
  std::vector<UnevenAxis> Axes(bool nearest) const;
};

/// Nothing where the input is empty.
/// @throws std::runtime_error a sentence, when it is nothing that can be drawn
std::optional<MapperInput> InputOf(vtkVolumeMapper* mapper, int port = 0);

}

#endif
