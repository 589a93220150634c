#ifndef Varimarch_Frame_OverlappingVolumes_h
#define Varimarch_Frame_OverlappingVolumes_h

#include "Frame/Frame.h"

#include <vector>

class vtkVariationFieldVolumeMapper;
class vtkVolume;

namespace varimarch
{

/// A volume, and the input of the mapper that it shows.
struct VolumeOfPort
{
  int port;
  vtkVolume* volume;
};

/// Those of a vtkMultiVolume whose ports have an input; of any other prop it itself, with the first
/// input.
std::vector<VolumeOfPort> VolumesOfPorts(vtkVariationFieldVolumeMapper* mapper, vtkVolume* prop);

/// One frame for several volumes that overlap: that of the first, with the others in it.
/// @param frames  one for each volume, more than one
/// @throws std::runtime_error a sentence, when they cannot be drawn together
Frame JoinedFrame(std::vector<Frame> frames, vtkVariationFieldVolumeMapper* mapper);

/// Smallest distance of two neighbouring voxels of any of a frame's volumes [mm].
double SmallestSpacingMm(const Frame& frame);

/// What a ray passes of all of them at most [mm].
double LongestRayMm(const Frame& frame);

/// The shortest side of any of them [mm].
double ThinnestSideMm(const Frame& frame);

/// The shortest distance of samples [mm]; see VolumeGeometry. Of several volumes each takes rounds
/// of its own for each segment.
double ShortestSampleDistanceMm(const Frame& frame);

/// More segments than any ray has.
int MostSegmentsOf(const Frame& frame);

}

#endif
