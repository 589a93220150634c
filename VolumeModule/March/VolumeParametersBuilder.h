#ifndef Varimarch_March_VolumeParametersBuilder_h
#define Varimarch_March_VolumeParametersBuilder_h

#include "Core/Parameters/MarchParameters.h"
#include "Resources/VolumeResources.h"

#include <vector>

namespace varimarch
{

/// The mapping from a marcher's scalars to values of the data, for each component.
using Mappings = std::vector<TexelMapping>;

/// The form in which one of the marchers reads a volume.
struct MarchedVolume
{
  Mappings mappings;
  VoxelRegion voxels; ///< All voxels, or those of a block.
  glm::ivec3 fieldSize;
  glm::ivec3 gapCells;
};

/// The form that shaders read: scalars are texels.
/// @param block  null if the shader marches no rays
MarchedVolume VolumeOfShaders(const VolumeMarch& march, const VolumeResources& volume,
  const VolumeBlock* block, const VoxelRegion& voxels);

/// The form that the processor reads: scalars are values of the data where floats can represent
/// these.
MarchedVolume VolumeOfProcessor(const VolumeResources& volume);

/// The parameters of a volume. Requires all its resources for the frame.
VolumeParameters VolumeParametersOf(
  const VolumeMarch& march, const VolumeResources& volume, const MarchedVolume& marched);

}

#endif
