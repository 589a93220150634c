#ifndef Varimarch_Frame_VolumeGeometry_h
#define Varimarch_Frame_VolumeGeometry_h

#include "Core/Geometry/Box.h"
#include "Core/Geometry/UnevenAxis.h"
#include "Core/Geometry/Viewport.h"

#include "VarimarchVolumeModule.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

class vtkImageData;
class vtkRenderer;
class vtkVolume;

namespace varimarch
{

/// The place of a volume. Grid space has the image's first voxel at (0,0,0), whatever its extent.
struct VolumeGeometry
{
  glm::ivec3 dimensions;    ///< The number of voxels along each axis.
  Box boxGrid;              ///< All cells; an axis with one voxel is one voxel thick.
  glm::dmat4 dataFromGrid;  ///< Extent, origin, spacing and direction of the image.
  glm::dmat4 worldFromGrid; ///< The same, then the volume's matrix.

  /// Mean spacing of the image over twice the spacing along each axis. These factors make
  /// differences of voxels two apart the gradients that VTK's gradient opacity is a function of.
  glm::dvec3 gradientFactors;

  double smallestGap = 1.0; ///< The smallest distance of neighbouring voxels in the grid.

  glm::dmat3 WorldFromGridDirection() const { return glm::dmat3(this->worldFromGrid); }

  /// Takes gradients, differences per voxel, to normals in the world.
  VARIMARCHVOLUME_EXPORT glm::dmat3 WorldFromGridNormal() const;

  /// Smallest distance of two neighbouring voxels in the world [mm].
  double SmallestSpacingMm() const;

  double ThinnestSideMm() const; ///< The shortest side of the volume [mm].

  /// Length of the longest ray through the volume [mm].
  double DiagonalMm() const;

  /// The shortest distance of samples by shaders [mm]: 20000 along the longest ray. Software
  /// rasterisers end a shader, and with it the ray, after 2^16 rounds of all its loops together, of
  /// which a sample takes up to three: where every segment is lit.
  double ShortestSampleDistanceMm() const;
};

/// The parts of an image that have the values. The voxel of a cell lies in its middle, and the
/// volume is drawn half a voxel beyond the outermost voxels, whose values continue there.
enum class VoxelPlace
{
  Points,
  Cells,
};

/// The geometry of a rectilinear grid: the even grid from its first voxel to its last.
VolumeGeometry VolumeGeometryOf(const std::vector<UnevenAxis>& axes, vtkVolume* volume);

VARIMARCHVOLUME_EXPORT VolumeGeometry VolumeGeometryOf(
  vtkImageData* image, vtkVolume* volume, VoxelPlace place = VoxelPlace::Points);

/// The transform from the grid of one volume to that of another.
glm::dmat4 GridFromGrid(const VolumeGeometry& to, const VolumeGeometry& from);

/// The part of the framebuffer that a renderer draws to.
Viewport ViewportOf(vtkRenderer* renderer);

/// The renderer's camera and projection, for its current tile and eye.
VARIMARCHVOLUME_EXPORT glm::dmat4 ClipFromWorld(vtkRenderer* renderer);

}

#endif
