#ifndef Varimarch_Core_Fields_VisibleBricks_h
#define Varimarch_Core_Fields_VisibleBricks_h

#include "Core/Fields/OpticalField.h"
#include "Core/Geometry/Box.h"
#include "Core/Packets/PacketScene.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace varimarch
{

/// A flag for each brick of a field that is visible: all that stays in main memory once a device
/// has the field.
class VisibleBricks
{
public:
  VisibleBricks() = default;
  explicit VisibleBricks(const OpticalField& field);

  /// The smallest box of whole bricks that contains everything visible in a part of the volume,
  /// clipped to the part [grid space]. A brick at a face of the part extends to that face. If
  /// nothing is visible, the box is empty: its lower corner is not below its upper corner.
  Box Bounds(const Box& partGrid) const;

private:
  int side = BrickRanges::CellsPerSide; ///< cells along each side of a brick
  glm::ivec3 brickCount = glm::ivec3(0);
  std::vector<bool> visible; ///< x fastest
};

/// Indices of the surface blocks: blocks of side^3 bricks that contain something visible and have a
/// face next to a block that does not, or to the outside.
std::vector<glm::ivec3> VisibleHull(const OpticalField& field, int side);

/// Cubes of the grid that bound what is visible: along any ray, nothing is visible before the first
/// cube or behind the last.
struct VisibleBlocks
{
  float sideGrid = 1.0f;
  std::vector<glm::vec3> centersGrid;
};

/// The depths that one thread has drawn.
struct VisibleLayer
{
  int columns = 0;            ///< number of packets per row
  std::vector<float> nearest; ///< least depth of each packet, along the view axis
  std::vector<float> farthest;
  bool isBounded = true; ///< false if a block touches the plane of the eye
};

/// Range of depths, for each packet of rays, in which something may be visible. Rays begin and end
/// there, and packets that see nothing are skipped. Blocks are drawn as their bounding rectangles.
/// This replaces a rasterizer's proxy geometry with two lookups per packet, instead of a dozen per
/// ray.
class VisibleDepths
{
public:
  /// @param directionGrid  any length, of the ray in the middle of the image
  /// @param pixels  part of the image; its packets begin at its lower left pixel
  /// @return the depths, valid until the next call; empty if a block touches the plane of the eye,
  /// since then everything may be visible
  PacketDepths Draw(const VisibleBlocks& blocks, const glm::dmat4& clipFromGrid,
    const glm::vec3& directionGrid, glm::ivec2 picturePixels, const Viewport& pixels);

private:
  /// The first layer becomes that of all blocks. Layers are kept, because allocating their memory
  /// for each frame may cost more than drawing into it.
  std::vector<VisibleLayer> layers;
};

}

#endif
