#ifndef Varimarch_PictureOfMapper_h
#define Varimarch_PictureOfMapper_h

#include "Frame.h"

class vtkVariationFieldVolumeMapper;

namespace varimarch
{

/// Takes over what the mapper's settings say of the picture: its window and level, its rays and
/// their noise.
void ChoosePicture(vtkVariationFieldVolumeMapper* mapper, Frame& frame);

}

#endif
