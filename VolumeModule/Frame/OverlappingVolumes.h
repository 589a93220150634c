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

/// The volumes of a vtkMultiVolume whose ports have an input. Any other prop counts as one volume,
/// at the first port.
std::vector<VolumeOfPort> VolumesOfPorts(vtkVariationFieldVolumeMapper* mapper, vtkVolume* prop);

/// Joins the frames of several volumes that overlap: the first, with the others as its members.
/// @param frames  one for each volume, at least two
/// @throws std::runtime_error with a sentence for the user, if they cannot be drawn together
Frame JoinFrames(std::vector<Frame> frames, vtkVariationFieldVolumeMapper* mapper);

}

#endif
