#ifndef Varimarch_Core_Fields_VisibleDepths_h
#define Varimarch_Core_Fields_VisibleDepths_h

#include "Core/Packets/PacketScene.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace varimarch
{

/// Cubes of the grid outside of which nothing is visible between the eye and the first of them, nor
/// behind the last.
struct VisibleBlocks
{
  float sideGrid = 1.0f;
  std::vector<glm::vec3> centersGrid;
};

/// What a thread has drawn of VisibleDepths.
struct VisibleLayer
{
  int columns = 0;            ///< of packets
  std::vector<float> nearest; ///< of each packet, along the axis
  std::vector<float> farthest;
  bool isBounded = true; ///< no block is beside the eye
};

/// Where along the view something may be visible, for each packet of a picture: rays then begin and
/// end there, and those of packets that see nothing are not begun. The blocks are drawn as
/// rectangles that hold them: what a rasteriser would do with a proxy geometry, for two lookups of
/// each packet in place of a dozen of each ray.
class VisibleDepths
{
public:
  /// @param directionGrid  any length, of the ray in the middle of the picture
  /// @param pixels  part of the picture, whose packets begin at its lower left pixel
  /// @return until the next are drawn; none where a block is beside the eye: then all may be
  /// visible
  PacketDepths Draw(const VisibleBlocks& blocks, const glm::dmat4& clipFromGrid,
    const glm::vec3& directionGrid, glm::ivec2 picturePixels, const Viewport& pixels);

private:
  /// The first becomes that of all blocks. They are kept: memory that is taken anew for each
  /// picture may cost more than what is drawn into it.
  std::vector<VisibleLayer> layers;
};

}

#endif
