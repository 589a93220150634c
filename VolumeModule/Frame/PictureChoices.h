#ifndef Varimarch_Frame_PictureChoices_h
#define Varimarch_Frame_PictureChoices_h

#include "Core/Quality/InteractiveQuality.h"
#include "Frame/Frame.h"

class vtkVariationFieldVolumeMapper;

namespace varimarch
{

/// Takes over what is asked of the picture: its window and level, its rays and their noise, whether
/// it is one of a selection, of layers or an image, and what code of its own it has.
void ChoosePicture(
  vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume, Frame& frame);

/// Lets a picture be coarser.
void UseQuality(const PictureQuality& quality, vtkVariationFieldVolumeMapper* mapper, Frame& frame);

}

#endif
