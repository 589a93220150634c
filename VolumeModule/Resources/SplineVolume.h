#ifndef Varimarch_Resources_SplineVolume_h
#define Varimarch_Resources_SplineVolume_h

#include "Resources/VolumeTexture.h"

#include "vtkSmartPointer.h"

#include <glm/vec3.hpp>

#include <vector>

class vtkDataArray;

namespace varimarch
{

/// The coefficients of the tricubic splines through the voxels of a volume (SplineCoefficients.h),
/// which then stand for the voxels on the graphics device and in all that is known of values.
class SplineVolume
{
public:
  /// A volume without a spline.
  SplineVolume() = default;

  /// @throws std::runtime_error if a voxel is not finite, because no coefficient would be finite
  /// then
  SplineVolume(const VoxelComponents& components, glm::ivec3 dimensions);

  /// The coefficients, in arrays that this object owns.
  VoxelComponents Components() const;

  /// The format of the coefficients in a texture. The range of the scalars is that of the voxels.
  std::vector<ScalarTexels> Texels(const VoxelComponents& voxels) const;

private:
  std::vector<vtkSmartPointer<vtkDataArray>> coefficients; ///< One for each component.
};

}

#endif
