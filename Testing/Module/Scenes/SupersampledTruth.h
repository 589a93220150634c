#ifndef Varimarch_Testing_SupersampledTruth_h
#define Varimarch_Testing_SupersampledTruth_h

#include "Module/Scenes/MapperScene.h"

#include <functional>
#include <vector>

/// The reference's image of the small torso in which each pixel is the mean of 8 x 8 rays.
/// @param prepare  sets the scene up
std::vector<float> SupersampledTruth(int size, const std::function<void(MapperScene&)>& prepare);

#endif
