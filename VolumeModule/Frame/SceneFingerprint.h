#ifndef Varimarch_Frame_SceneFingerprint_h
#define Varimarch_Frame_SceneFingerprint_h

#include "Frame/Fingerprint.h"

class vtkVariationFieldVolumeMapper;

namespace varimarch
{

struct Frame;

/// The arrays that are drawn, and the time of their last change.
Fingerprint VoxelFingerprint(const Frame& frame);

/// Everything in a volume and its look that the part of a light depends on that it lets through.
Fingerprint ExtinctionFingerprint(const Frame& frame);

/// Everything in a volume and its transfer functions that an image depends on in any view and any
/// light.
Fingerprint UnlitFingerprint(const Frame& frame);

/// Everything in a volume, its look and its lights that an image depends on in any view. Changes by
/// observers of vtkCommand::UpdateShaderEvent are not included.
Fingerprint VolumeFingerprint(const Frame& frame);

/// The same with the view, the opaque geometry and all settings of the mapper: images with the same
/// fingerprint are equal.
/// @param frame  a frame that has the fingerprint of its volume
Fingerprint ImageFingerprint(vtkVariationFieldVolumeMapper* mapper, const Frame& frame);

}

#endif
