#ifndef Varimarch_Frame_SceneFingerprint_h
#define Varimarch_Frame_SceneFingerprint_h

#include <vector>

class vtkVariationFieldVolumeMapper;

namespace varimarch
{

struct Frame;
struct VoxelInput;

/// The arrays that are drawn, and the time of their last change, as numbers.
std::vector<double> VoxelFingerprint(const VoxelInput& voxels);

/// Everything in a volume and its look that the part of a light depends on that it lets through.
std::vector<double> ExtinctionFingerprint(const Frame& frame);

/// Everything in a volume and its look that an image depends on in any view, as numbers and
/// modification times. Changes by observers of vtkCommand::UpdateShaderEvent are not included.
std::vector<double> VolumeFingerprint(const Frame& frame);

/// The same with the view, the opaque geometry and all settings of the mapper: images with the same
/// fingerprint are equal.
/// @param frame  a frame that has the fingerprint of its volume
std::vector<double> ImageFingerprint(vtkVariationFieldVolumeMapper* mapper, const Frame& frame);

}

#endif
