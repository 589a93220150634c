#ifndef Varimarch_Readers_Preview_h
#define Varimarch_Readers_Preview_h

#include "Core/Blocks/BrickSource.h"
#include "Readers/VolumeFile.h"
#include "Readers/VoxelLayout.h"

namespace varimarch
{

/// A copy of every few voxels of a source, at the origin, with spacing 1: at most 2^24 voxels, for
/// which at most 500 MB of slices are looked at.
/// @param layout  that of the source
/// @throws std::runtime_error if the source cannot be read
/// @throws ReadCancelled
vtkSmartPointer<vtkImageData> CoarseCopy(
  const BrickSource& source, const VoxelLayout& layout, PreviewWish& wish, ReadProgress& progress);

/// The sentence about a copy of a volume.
std::string SentenceAboutPreview(const VoxelLayout& copy, const VoxelLayout& volume);

}

#endif
