#ifndef Varimarch_Frame_MissingFeatures_h
#define Varimarch_Frame_MissingFeatures_h

#include <string>

class vtkRenderer;
class vtkVariationFieldVolumeMapper;
class vtkVolume;

namespace varimarch
{

/// Sentences that name the requested features which an image would lack, each followed by a space.
/// Empty if the image would have all of them.
std::string MissingFeatures(vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume);

/// Sentences that say why a request cannot be drawn, or not with all of its features. Empty if it
/// can.
std::string UnsupportedFeature(
  vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);

}

#endif
