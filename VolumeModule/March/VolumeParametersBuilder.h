#ifndef Varimarch_March_VolumeParametersBuilder_h
#define Varimarch_March_VolumeParametersBuilder_h

#include "Core/Parameters/MarchParameters.h"
#include "Resources/VolumeResources.h"

#include <vector>

namespace varimarch
{

/// How a marcher's scalars stand for the values of each component.
using Mappings = std::vector<TexelMapping>;

/// A volume as one of the marchers reads it.
struct MarchedVolume
{
  Mappings mappings;
  VoxelRegion voxels; ///< all voxels, or those of a block
  glm::ivec3 fieldSize;
  glm::ivec3 gapCells;
};

/// A volume as shaders read it, whose scalars are texels.
/// @param block  null where rays are not marched
MarchedVolume VolumeOfShaders(const VolumeMarch& march, const VolumeResources& volume,
  const VolumeBlock* block, const VoxelRegion& voxels);

/// A volume as the processor reads it, whose scalars are values of the data.
MarchedVolume VolumeOfProcessor(const VolumeMarch& march, const VolumeResources& volume);

/// The numbers of a volume that is marched, when all its resources for the frame are there.
VolumeParameters VolumeParametersOf(
  const VolumeMarch& march, const VolumeResources& volume, const MarchedVolume& marched);

}

#endif
