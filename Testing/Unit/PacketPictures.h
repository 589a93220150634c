#ifndef Varimarch_Testing_PacketPictures_h
#define Varimarch_Testing_PacketPictures_h

#include "Core/Look/OpticalTable.h"
#include "Core/Look/PreIntegratedTable.h"
#include "Core/Packets/PacketMarch.h"
#include "Core/Reference/ReferenceIntegrator.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace varimarch
{

/// The subject of an image: a volume, its look, and the size of the image.
struct PacketSubject
{
  std::vector<std::int16_t> voxels; ///< values from 0 to 100, of PacketPictures::Dimensions
  TransferFunction look;            ///< over a unit distance of 2 mm
  glm::ivec2 pixels;
};

/// A small volume, seen in perspective from the side. Both packets of rays and the reference
/// integrator render it. The scene of the packets is set up by hand, without a mapper.
class PacketPictures
{
public:
  static constexpr glm::ivec3 Dimensions = glm::ivec3(21, 11, 12);
  static constexpr double UnitDistanceMm = 2.0;

  /// A volume of smooth values.
  PacketPictures();
  explicit PacketPictures(PacketSubject subject);
  // The scene points into this object.
  PacketPictures(const PacketPictures&) = delete;
  void operator=(const PacketPictures&) = delete;

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
  /// Integrates exactly between samples, by a table that this object keeps.
  void PreIntegrate();
  void LightFromTheEye();

  Viewport Pixels() const { return { 0, 0, this->view.width, this->view.height }; }

  /// The images: premultiplied, the bottom row first.
  std::vector<float> March(InstructionSet set) const;
  std::vector<float> Truth() const;

private:
  std::vector<std::int16_t> voxels;
  glm::dmat3 worldFromGrid;
  OpticalTable table;
  std::optional<PreIntegratedTable> preIntegrated;
  ReferenceView view;
};

}

#endif
