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
  /// None: there is no spline.
  SplineVolume() = default;

  /// @throws std::runtime_error where a voxel is not finite, for then no coefficient would be
  SplineVolume(const VoxelChannels& channels, glm::ivec3 dimensions);

  /// Arrays that this owns.
  VoxelChannels Channels() const;

  /// How a texture holds them, with the range of the voxels as that of the scalars.
  std::vector<ScalarTexels> Texels(const VoxelChannels& voxels) const;

private:
  std::vector<vtkSmartPointer<vtkDataArray>> coefficients; ///< of each channel
};

}

#endif
