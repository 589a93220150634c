#ifndef Varimarch_Readers_Paging_MappedVoxels_h
#define Varimarch_Readers_Paging_MappedVoxels_h

#include "Readers/Paging/PagedVoxels.h"
#include "Readers/VoxelFile.h"

#include <cstdint>
#include <memory>
#include <string>

namespace varimarch
{

/// The reason why the voxels of a file cannot be used where they are, as the rest of a sentence
/// about them; empty if they can. Only types that packets of rays read are of use there.
/// @param offset  offset of the first voxel in the file
std::string ObstacleToMapping(
  const VoxelFile& file, const VoxelLayout& layout, std::uint64_t offset);

/// Voxels that a file has as they are in memory.
struct VoxelsInFile
{
  std::string path;
  VoxelLayout layout;   ///< one component of a type of VoxelTypeOf
  std::uint64_t offset; ///< offset of the first voxel in the file
  Mapping mapping;      ///< with a bound of the memory
};

/// An image of voxels that stay in their file, at the origin, with spacing 1. Its scalars own the
/// mapped file, and know the summary. If a preview is wished for and no summary is kept, the image
/// is a coarse copy instead.
/// @throws std::runtime_error if the file cannot be mapped, or the memory does not suffice for
/// what belongs to its bricks
/// @throws ReadCancelled
vtkSmartPointer<vtkImageData> MappedImage(const VoxelsInFile& voxels, ReadProgress& progress);

/// The same of any paged voxels.
/// @param mostBytes  see KeepPaged
vtkSmartPointer<vtkImageData> PagedImage(std::unique_ptr<PagedVoxels> voxels,
  const VoxelLayout& layout, std::shared_ptr<const VolumeSummary> summary, std::uint64_t mostBytes);

}

#endif
