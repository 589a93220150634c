#ifndef Varimarch_Frame_FrameMeasures_h
#define Varimarch_Frame_FrameMeasures_h

#include "Frame/Frame.h"

namespace varimarch
{

// World lengths that bound the steps of a frame, over all of its volumes.

/// The smallest distance of two neighbouring voxels [mm].
double SmallestSpacingMm(const Frame& frame);

/// An upper bound of the length of a ray within the volumes [mm].
double LongestRayMm(const Frame& frame);

/// The shortest side of the volumes, or of the pieces that parallel cuts leave of them [mm].
double ThinnestPieceMm(const Frame& frame);

/// The shortest sample distance that the marcher supports [mm], see
/// VolumeGeometry::ShortestSampleDistanceMm.
double ShortestSampleDistanceMm(const Frame& frame, Marcher marcher);

/// An upper bound of the number of segments of a ray: the samples along the diagonal plus the voxel
/// faces that a ray can cross.
int MostSegments(const Frame& frame, double sampleDistanceMm);

}

#endif
