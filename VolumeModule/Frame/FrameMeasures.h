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

/// A box in the coordinates of the data, in those of the grid of the frame's volume.
Box BoxInGrid(const Frame& frame, const Box& data);

/// The diagonal of a box in grid coordinates of the frame's volume [mm].
double DiagonalMm(const Frame& frame, const Box& grid);

/// The shortest side of the volumes, or of the pieces that parallel cuts leave of them [mm].
/// @param grid  the box of the first volume, in its grid coordinates
double ThinnestPieceMm(const Frame& frame, const Box& grid);

/// The shortest sample distance that the marcher supports [mm], see
/// VolumeGeometry::ShortestSampleDistanceMm.
double ShortestSampleDistanceMm(const Frame& frame, Marcher marcher);

/// An upper bound of the number of segments of a ray: the samples along the diagonal plus the voxel
/// faces that a ray can cross.
int MostSegments(const Frame& frame, double sampleDistanceMm);

}

#endif
