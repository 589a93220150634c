#ifndef Varimarch_Readers_Rectify_h
#define Varimarch_Readers_Rectify_h

#include "Readers/VolumeFile.h"

namespace varimarch
{

/// Resamples a volume of irregular slices to an even, orthogonal grid. The grid runs along the
/// rows, the columns and the normal of the slices, from the first to the last, and encloses all of
/// them. It keeps the scan's voxel spacing within a slice, and the spacing of the denser slices
/// between slices. Values are interpolated linearly between the slices before and behind, and
/// bilinearly in these. Outside the scan they are the lowest value of the volume.
///
/// vtkDICOMCTRectifier does this for a tilted gantry. However, it cuts off what the tilt moves out
/// of the first slice's frame, fills with 0, supports only even distances, and cannot be cancelled.
///
/// @param path  path for the error message
/// @param volume  a volume with irregularSlicesMm
/// @throws std::runtime_error if the resampled volume does not fit in memory
/// @throws ReadCancelled
Volume Rectified(const std::string& path, const Volume& volume, ReadProgress& progress);

}

#endif
