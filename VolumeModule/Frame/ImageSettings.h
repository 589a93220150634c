#ifndef Varimarch_Frame_ImageSettings_h
#define Varimarch_Frame_ImageSettings_h

#include "Frame/Frame.h"

class vtkVariationFieldVolumeMapper;

namespace varimarch
{

struct MapperNumbers;

/// Takes the settings of the image from a mapper: window and level, the distance between rays and
/// their jitter, the requested pass, accumulation, and the user's shader code. Requires the view.
void ApplyImageSettings(
  vtkVariationFieldVolumeMapper* mapper, const MapperNumbers& numbers, Frame& frame);

}

#endif
