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
class vtkMatrix4x4;
class vtkRenderer;
class vtkVolume;

namespace varimarch
{

/// The position and shape of a volume. The origin of grid space is the image's first voxel,
/// whatever the extent; its unit is the distance between voxels.
struct VolumeGeometry
{
  glm::ivec3 dimensions;    ///< The number of voxels along each axis.
  Box boxGrid;              ///< The box of all cells; an axis with one voxel is one voxel thick.
  glm::dmat4 dataFromGrid;  ///< Extent, origin, spacing and direction of the image.
  glm::dmat4 worldFromGrid; ///< The product of the volume's matrix and `dataFromGrid`.

  /// Mean spacing of the image over twice the spacing along each axis. These factors turn
  /// differences of voxels two apart into the gradients that VTK's gradient opacity depends on.
  glm::dvec3 gradientFactors;

  double smallestGap = 1.0; ///< The smallest distance between neighbouring voxels [grid space].

  glm::dmat3 WorldFromGridDirection() const { return glm::dmat3(this->worldFromGrid); }

  /// Transforms gradients, in differences per voxel, to normals in world space.
  VARIMARCHVOLUME_EXPORT glm::dmat3 WorldFromGridNormal() const;

  /// The smallest distance between neighbouring voxels in world space [mm].
  double SmallestSpacingMm() const;

  /// The length of the longest ray through the volume [mm].
  VARIMARCHVOLUME_EXPORT double DiagonalMm() const;

  /// The shortest sample distance of shaders [mm], which puts 20000 samples on the longest ray.
  /// Software rasterisers end a shader, and with it the ray, after 2^16 iterations of all its loops
  /// together, and a sample takes up to three iterations if every segment is lit.
  double ShortestSampleDistanceMm() const;
};

/// The elements of an image that have the values. The voxel of a cell lies at its centre, and the
/// volume extends half a voxel beyond the outermost voxels, whose values continue there.
enum class VoxelPlace
{
  Points,
  Cells,
};

/// The geometry of a rectilinear grid, as the even grid between its first and last voxels.
VolumeGeometry VolumeGeometryOf(const std::vector<UnevenAxis>& axes, vtkVolume* volume);

VARIMARCHVOLUME_EXPORT VolumeGeometry VolumeGeometryOf(
  vtkImageData* image, vtkVolume* volume, VoxelPlace place = VoxelPlace::Points);

/// The reach of ambient occlusion [mm].
/// @param chosenMm  0: 16 times the smallest distance between voxels
VARIMARCHVOLUME_EXPORT double OcclusionReachMm(double chosenMm, const VolumeGeometry& geometry);

/// The length of rays to lights through a volume [mm].
/// @param part  as vtkGPUVolumeRayCastMapper::GlobalIlluminationReach: 0: none; 1: infinite
VARIMARCHVOLUME_EXPORT double ShadowReachMm(double part, const VolumeGeometry& geometry);

/// Checks that a volume has a place in the world and a thickness along each axis.
/// @throws std::invalid_argument with a sentence for the user, if it has none
void CheckPlaces(const VolumeGeometry& geometry);

/// Checks that a camera sees the world.
/// @throws std::invalid_argument with a sentence for the user, if it does not
void CheckView(vtkRenderer* renderer);

/// True if none of a matrix's numbers is NaN or infinite.
bool IsFinite(const glm::dmat4& matrix);

/// The transform from the grid of one volume to that of another.
glm::dmat4 GridFromGrid(const VolumeGeometry& to, const VolumeGeometry& from);

/// The part of the framebuffer that a renderer draws to.
Viewport ViewportOf(vtkRenderer* renderer);

/// The matrix in GLM's order: VTK stores rows, GLM columns.
VARIMARCHVOLUME_EXPORT glm::dmat4 FromVtk(vtkMatrix4x4* matrix);

/// The renderer's camera and projection, for its current tile and eye.
VARIMARCHVOLUME_EXPORT glm::dmat4 ClipFromWorld(vtkRenderer* renderer);

}

#endif
