#ifndef Varimarch_Frame_FrameBuilder_h
#define Varimarch_Frame_FrameBuilder_h

#include "Frame/Frame.h"

#include <optional>
#include <string>

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

/// Sentences that name the requested features which an image would lack, each followed by a space.
/// Empty if the image would have all of them.
std::string MissingFeatures(vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume);

/// Sentences that say why a request cannot be drawn, or not with all of its features. Empty if it
/// can.
std::string UnsupportedFeature(
  vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);

}

#endif
