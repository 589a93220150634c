#ifndef Varimarch_Resources_SplineVolume_h
#define Varimarch_Resources_SplineVolume_h

#include "Resources/VolumeTexture.h"

#include "vtkSmartPointer.h"

#include <glm/vec3.hpp>

#include <vector>

class vtkDataArray;

namespace varimarch
{

/// The coefficients of the tricubic splines through the voxels of a volume (SplineCoefficients.h).
/// They replace the voxels on the graphics device and in everything computed from values.
class SplineVolume
{
public:
  /// Makes an empty spline.
  SplineVolume() = default;

  /// @throws std::runtime_error if a voxel is not finite, because then no coefficient would be
  SplineVolume(const VoxelComponents& components, glm::ivec3 dimensions);

  /// The coefficients, in arrays that this object owns.
  VoxelComponents Components() const;

  /// The texel format of the coefficients. Its range of scalars is that of the voxels.
  std::vector<ScalarTexels> Texels(const VoxelComponents& voxels) const;

private:
  std::vector<vtkSmartPointer<vtkDataArray>> coefficients; ///< The coefficients of each component.
};

}

#endif
