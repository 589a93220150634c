#ifndef Varimarch_Core_Packets_VisibleDepths_h
#define Varimarch_Core_Packets_VisibleDepths_h

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

/// Where along the view something may be visible, for each packet of a picture: rays then begin and
/// end there, and those of packets that see nothing are not begun. The blocks are drawn as
/// rectangles that hold them: what a rasteriser would do with a proxy geometry, for two lookups of
/// each packet in place of a dozen of each ray.
class VisibleDepths
{
public:
  /// @param pixels  part of the picture, whose packets begin at its lower left pixel
  VisibleDepths(const VisibleBlocks& blocks, const glm::dmat4& clipFromGrid,
    const PacketCamera& camera, const Viewport& pixels);

  /// None where a block is beside the eye: then all may be visible.
  PacketDepths Depths() const;

private:
  glm::vec3 axisGrid;
  int firstColumn; ///< of packets
  int firstRow;
  int columns;
  int rows;
  bool isBounded = true;
  std::vector<float> nearest; ///< along the axis, of each packet
  std::vector<float> farthest;
};

}

#endif
