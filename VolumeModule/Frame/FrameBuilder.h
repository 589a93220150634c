#ifndef Varimarch_Frame_FrameBuilder_h
#define Varimarch_Frame_FrameBuilder_h

#include "Frame/Frame.h"

#include <optional>

class vtkImageData;
class vtkRenderer;
class vtkVariationFieldVolumeMapper;
class vtkVolume;

namespace varimarch
{

/// Collects the input and the present settings of a mapper. Returns nothing if the input is empty.
/// @param instead  an image with point data that is drawn instead of the input of a single volume;
/// null for the input
/// @throws std::runtime_error with a sentence for the user, if the input cannot be drawn
std::optional<Frame> BuildFrame(vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer,
  vtkVolume* volume, vtkImageData* instead = nullptr);

}

#endif
