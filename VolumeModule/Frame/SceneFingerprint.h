#ifndef Varimarch_Frame_SceneFingerprint_h
#define Varimarch_Frame_SceneFingerprint_h

#include <vector>

class vtkVariationFieldVolumeMapper;

namespace varimarch
{

struct Frame;

/// All that a picture depends on, as numbers and times of modification: two pictures of equal ones
/// are the same. Code that observes vtkCommand::UpdateShaderEvent is not known here.
std::vector<double> NumbersOfScene(vtkVariationFieldVolumeMapper* mapper, const Frame& frame);

}

#endif
