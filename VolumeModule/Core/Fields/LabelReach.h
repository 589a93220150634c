#ifndef Varimarch_Core_Fields_LabelReach_h
#define Varimarch_Core_Fields_LabelReach_h

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace varimarch
{

/// For each voxel v of a mask, how far its label goes: k + 1 where all voxels v - k ... v + k on
/// each axis, cut at the mask's faces, have the same; exact up to 255.
/// @param labels  x fastest
std::vector<std::uint16_t> LabelReach(const std::vector<std::uint16_t>& labels, glm::ivec3 size);

}

#endif
