#ifndef Varimarch_Readers_Paging_Preview_h
#define Varimarch_Readers_Paging_Preview_h

#include "Core/Blocks/BrickSource.h"
#include "Readers/VoxelFile.h"
#include "Readers/VoxelLayout.h"

namespace varimarch
{

/// A copy of every few voxels of a source, at the origin, with spacing 1: at most 2^24 voxels in a
/// quarter of the memory, beyond which voxels stay in their file, so that it is always coarser. At
/// most 500 MB of slices are looked at.
/// @param layout   that of the source
/// @param mapping  the bound of the memory, and the wish for the copy
/// @throws std::runtime_error if the source cannot be read
/// @throws ReadCancelled
vtkSmartPointer<vtkImageData> CoarseCopy(const BrickSource& source, const VoxelLayout& layout,
  const Mapping& mapping, ReadProgress& progress);

/// The sentence about a copy of a volume.
std::string SentenceAboutPreview(const VoxelLayout& copy, const VoxelLayout& volume);

}

#endif
