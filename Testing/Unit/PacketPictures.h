#ifndef Varimarch_Testing_PacketPictures_h
#define Varimarch_Testing_PacketPictures_h

#include "Core/Look/OpticalTable.h"
#include "Core/Packets/PacketMarch.h"
#include "Core/Reference/ReferenceImage.h"

#include <cstdint>
#include <vector>

namespace varimarch
{

/// A small volume of smooth values from 0 to 100, seen in perspective from the side. Both packets
/// of rays and the reference integrator render it. The scene of the packets is set up by hand,
/// without a mapper.
class PacketPictures
{
public:
  static constexpr int Width = 37; // neither side is a multiple of a packet's
  static constexpr int Height = 30;
  static constexpr glm::ivec3 Dimensions = glm::ivec3(21, 11, 12);

  PacketPictures();

  /// A scene of packets that march 16-bit voxels by midpoints, without light; tests modify it.
  PacketScene scene;

  /// The same scene for the reference; tests modify it.
  ReferenceScene truth;

  ScalarGrid<std::int16_t> Grid() const { return { this->voxels.data(), Dimensions }; }
  const OpticalTable& Table() const { return this->table; }
  const glm::dmat3& WorldFromGrid() const { return this->worldFromGrid; }

  /// The voxels converted to another type.
  template <class Voxel>
  std::vector<Voxel> Converted() const
  {
    return { this->voxels.begin(), this->voxels.end() };
  }

  void UseTable(const std::vector<glm::vec4>& entries, int lastIndex);
  void LightFromTheEye();

  /// The images: premultiplied, the bottom row first.
  std::vector<float> March(InstructionSet set) const;
  std::vector<float> Truth() const;

private:
  std::vector<std::int16_t> voxels;
  glm::dmat3 worldFromGrid;
  OpticalTable table;
  ReferenceView view;
};

}

#endif
