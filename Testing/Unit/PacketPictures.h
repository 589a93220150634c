#ifndef Varimarch_Testing_PacketPictures_h
#define Varimarch_Testing_PacketPictures_h

#include "Core/Packets/PacketMarch.h"
#include "Core/Reference/ReferenceImage.h"

#include <cstdint>
#include <vector>

namespace varimarch
{

/// A small volume of smooth values from 0 to 100, seen in perspective from the side, whose image
/// both packets of rays and the reference integrator draw. No mapper: the scene of the packets is
/// made by hand.
class PacketPictures
{
public:
  static constexpr int Width = 37; // neither is a multiple of a packet's
  static constexpr int Height = 30;
  static constexpr glm::ivec3 Dimensions = glm::ivec3(21, 11, 12);

  PacketPictures();

  /// A scene of packets that march 16 bit voxels by midpoints, without light; to be changed.
  PacketScene scene;

  /// The same for the reference; to be changed.
  ReferenceScene truth;

  ScalarGrid<std::int16_t> Grid() const { return { this->voxels.data(), Dimensions }; }
  const OpticalTable& Table() const { return this->table; }
  const glm::dmat3& WorldFromGrid() const { return this->worldFromGrid; }

  /// The voxels in another type.
  template <class Voxel>
  std::vector<Voxel> Converted() const
  {
    return { this->voxels.begin(), this->voxels.end() };
  }

  void UseTable(const std::vector<glm::vec4>& entries, int lastIndex);
  void LightFromTheEye();

  /// The images, premultiplied, row 0 the lowest.
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
