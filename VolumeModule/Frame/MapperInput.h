#ifndef Varimarch_Frame_MapperInput_h
#define Varimarch_Frame_MapperInput_h

#include "Core/Geometry/UnevenAxis.h"
#include "Frame/VolumeGeometry.h"

#include "vtkType.h"

#include <optional>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkDataSet;
class vtkVolumeMapper;

namespace varimarch
{

/// The input of a mapper.
struct MapperInput
{
  vtkDataSet* data; ///< An image or a rectilinear grid.
  vtkDataArray* scalars;
  VoxelPlace place; ///< Points or cells, whichever have the scalars.

  glm::ivec3 PointCount() const;

  /// The time of the last change.
  vtkMTimeType Time() const;

  VolumeGeometry Geometry(vtkVolume* volume, const std::vector<UnevenAxis>& axes) const;

  /// The axes of a rectilinear grid; empty for an image.
  std::vector<UnevenAxis> Axes(bool nearest) const;
};

/// An image with point data as an input.
MapperInput InputOf(vtkImageData* image);

/// The input of a port; nothing if it is empty.
/// @throws std::runtime_error with a sentence for the user, if the input cannot be drawn
std::optional<MapperInput> InputOf(vtkVolumeMapper* mapper, int port = 0);

}

#endif
