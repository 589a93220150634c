#ifndef Varimarch_Frame_FrameMeasures_h
#define Varimarch_Frame_FrameMeasures_h

#include "Frame/Frame.h"

namespace varimarch
{

// Lengths of a frame in the world that bound its steps. They take all of its volumes together.

/// The smallest distance of two neighbouring voxels [mm].
double SmallestSpacingMm(const Frame& frame);

/// A bound of the length of a ray within the volumes [mm].
double LongestRayMm(const Frame& frame);

/// The shortest side of a volume [mm].
double ThinnestSideMm(const Frame& frame);

/// The shortest distance of samples that the marcher can take [mm], see
/// VolumeGeometry::ShortestSampleDistanceMm.
double ShortestSampleDistanceMm(const Frame& frame, Marcher marcher);

/// A bound of the number of segments of a ray: the samples along the diagonal, and the faces of
/// voxels that a ray can cross.
int MostSegments(const Frame& frame, double sampleDistanceMm);

}

#endif
