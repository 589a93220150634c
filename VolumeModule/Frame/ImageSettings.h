#ifndef Varimarch_Frame_ImageSettings_h
#define Varimarch_Frame_ImageSettings_h

#include "Frame/Frame.h"

class vtkVariationFieldVolumeMapper;

namespace varimarch
{

/// Takes the settings of the image from a mapper: window and level, the distance between rays and
/// their jitter, the requested pass, accumulation, and the user's shader code.
void ApplyImageSettings(
  vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume, Frame& frame);

}

#endif
