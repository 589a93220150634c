#ifndef Varimarch_Frame_SceneFingerprint_h
#define Varimarch_Frame_SceneFingerprint_h

#include <vector>

class vtkVariationFieldVolumeMapper;

namespace varimarch
{

struct Frame;

/// Everything that an image depends on, as numbers and modification times: images with the same
/// fingerprint are equal. Changes by observers of vtkCommand::UpdateShaderEvent are not included.
std::vector<double> Fingerprint(vtkVariationFieldVolumeMapper* mapper, const Frame& frame);

}

#endif
