#ifndef Varimarch_Core_Fields_LabelReach_h
#define Varimarch_Core_Fields_LabelReach_h

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace varimarch
{

/// Extent of the label around each voxel v of a mask: k + 1 if all voxels v - k ... v + k on each
/// axis, clipped to the mask, have the same label. Exact up to 255.
/// @param labels  x fastest
std::vector<std::uint16_t> LabelReach(const std::vector<std::uint16_t>& labels, glm::ivec3 size);

}

#endif
