#ifndef Varimarch_Frame_FrameBuilder_h
#define Varimarch_Frame_FrameBuilder_h

#include "Frame/Frame.h"

#include <optional>
#include <string>

class vtkRenderer;
class vtkVariationFieldVolumeMapper;
class vtkVolume;

namespace varimarch
{

/// What a mapper is to draw with its settings as they are; nothing where its input is empty.
/// @throws std::runtime_error a sentence, when nothing can be drawn of it
std::optional<Frame> FrameOf(
  vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);

/// What a picture lacks of what is asked for: sentences, each followed by a space; empty when it
/// lacks nothing.
std::string MissingFeatures(vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume);

/// Why a picture would not be all that is asked for, be it that nothing can be drawn or that it
/// lacks a feature; empty when it would be.
std::string UnsupportedFeature(
  vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume);

}

#endif
