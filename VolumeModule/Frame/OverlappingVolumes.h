#ifndef Varimarch_Frame_OverlappingVolumes_h
#define Varimarch_Frame_OverlappingVolumes_h

#include "Frame/Frame.h"

#include <vector>

class vtkVariationFieldVolumeMapper;
class vtkVolume;

namespace varimarch
{

/// A volume of a prop, and the port of the mapper that has its input.
struct VolumeOfPort
{
  int port;
  vtkVolume* volume;
};

/// The volumes of a vtkMultiVolume whose ports have an input. Any other prop is its own only
/// volume, with the first input.
std::vector<VolumeOfPort> VolumesOfPorts(vtkVariationFieldVolumeMapper* mapper, vtkVolume* prop);

/// One frame for several volumes that overlap: that of the first, with the others in it.
/// @param frames  one for each volume, more than one
/// @throws std::runtime_error a sentence, if they cannot be drawn together
Frame JoinFrames(std::vector<Frame> frames, vtkVariationFieldVolumeMapper* mapper);

}

#endif
