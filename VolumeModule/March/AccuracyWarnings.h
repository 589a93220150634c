#ifndef Varimarch_March_AccuracyWarnings_h
#define Varimarch_March_AccuracyWarnings_h

#include <string>

class vtkVariationFieldVolumeMapper;

namespace varimarch
{

class RayMarcher;

/// Sentences about the accuracy that the last frame lacks; empty if it lacks none.
std::string AccuracyWarnings(vtkVariationFieldVolumeMapper* mapper, const RayMarcher& marcher);

}

#endif
