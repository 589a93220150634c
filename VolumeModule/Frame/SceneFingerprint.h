#ifndef Varimarch_Frame_SceneFingerprint_h
#define Varimarch_Frame_SceneFingerprint_h

#include <vector>

class vtkVariationFieldVolumeMapper;

namespace varimarch
{

struct Frame;

/// Everything that an image depends on, as numbers and times of modification: images with the same
/// fingerprint are the same. Code that observes vtkCommand::UpdateShaderEvent is not known here.
std::vector<double> Fingerprint(vtkVariationFieldVolumeMapper* mapper, const Frame& frame);

}

#endif
