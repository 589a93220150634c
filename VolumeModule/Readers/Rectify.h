#ifndef Varimarch_Readers_Rectify_h
#define Varimarch_Readers_Rectify_h

#include "Readers/VolumeFile.h"

namespace varimarch
{

/// Resamples a volume whose slices lie irregularly on a grid with even distances and right angles.
/// The grid lies along the rows, the columns and the normal of the slices, from the first to the
/// last, and holds all of them. Along a slice its voxels are as the scan's; from slice to slice
/// they are as near as the nearer ones of the scan. Values are interpolated linearly between the
/// slices before and behind, and in those between the voxels around; outside they are the lowest
/// of the volume.
///
/// vtkDICOMCTRectifier, which does this for a tilted gantry, cuts off what the tilt moves out of
/// the first slice's frame, fills with 0, knows only even distances, and cannot be stopped.
///
/// @param path    for the error message
/// @param volume  with irregularSlicesMm; without it comes back as it is
/// @throws std::runtime_error when the resampled volume does not fit the memory
/// @throws ReadCancelled
Volume Rectified(const std::string& path, const Volume& volume, ReadProgress& progress);

}

#endif
