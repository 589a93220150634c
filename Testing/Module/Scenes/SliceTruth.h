#ifndef Varimarch_Testing_SliceTruth_h
#define Varimarch_Testing_SliceTruth_h

#include "Module/Scenes/MapperScene.h"

#include <vector>

/// The image of a slice by the property's function, which must be of second degree, over one
/// component with linear interpolation, unlit. The reference integrator has no slices: this finds
/// the roots of the function along each ray, and shows the value at each by VTK's definition.
/// @return premultiplied RGBA, the bottom row first
std::vector<float> SliceTruth(MapperScene& scene);

#endif
