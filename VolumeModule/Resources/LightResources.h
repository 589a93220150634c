#ifndef Varimarch_Resources_LightResources_h
#define Varimarch_Resources_LightResources_h

#include "Core/Fields/LightLattice.h"
#include "Core/Packets/PacketScene.h"
#include "Frame/MarchPlan.h"
#include "Resources/FloatTable.h"
#include "Resources/MaterialResources.h"

#include <cstddef>
#include <vector>

namespace varimarch
{

/// The lattices of the lights that cast shadows in a volume, one for each light and material, and
/// of the light from all around, which packets of rays fill while they draw. A lattice is kept as
/// long as its light, the volume and its opacities stay, whatever the view. There are none without
/// an error tolerance, and none of shadows where a voxel may be all but opaque: they are then
/// thinner than the cells of a lattice. A march may leave them out (LightSource), which shows their
/// error. Volumes that overlap have lattices of their own, whose light is multiplied; only ambient
/// occlusion, which knows no product, takes all of them into account.
class LightResources
{
public:
  /// @throws std::runtime_error if there is no memory
  /// @param materials  the look of the volume
  void Update(const VolumeMarch& march, const MaterialResources& materials);

  /// The lattices of one of the volume's materials, and how exactly a march computes shadows.
  PacketShadows Shadows(const VolumeMarch& march, int part) const;

  /// The lattice, and how exactly a march computes ambient occlusion.
  PacketSky Sky(const VolumeMarch& march) const;

  /// ExtinctionSums of an optical table; null if packets do not ask how matter dims light.
  const double* ExtinctionSumsOf(std::size_t table) const
  {
    return this->sums.empty() ? nullptr : this->sums[table].data();
  }

  /// True if a march may take light from a lattice.
  bool HasLattices() const { return !this->kept.empty(); }

  /// The directions of ambient occlusion.
  MarchTexture SkyDirections() const { return this->directions.Texture(); }
  std::size_t GraphicsBytes() const { return this->directions.Bytes(); }

  /// The memory of all lattices, of which only pages that are used are taken from the system.
  std::size_t Bytes() const;

  /// How many lattices were begun.
  int Builds() const { return this->builds; }

  void Release(vtkWindow* window);

private:
  /// The lattice of a light.
  struct Kept
  {
    Fingerprint inputs; ///< Everything that its light depends on.
    LightLattice lattice;
  };

  void UpdateShadows(
    const VolumeMarch& march, const MaterialResources& materials, std::vector<Kept>& now);
  void KeepLattices(const VolumeMarch& march, std::vector<Kept>& now);
  void UpdateSky(const VolumeMarch& march, std::vector<Kept>& now);
  void UpdateDirections(const VolumeMarch& march);
  void UpdateSums(const VolumeMarch& march, const MaterialResources& materials);
  std::uint8_t* KeepNodes(Fingerprint inputs, const LatticeShape& shape, std::vector<Kept>& now);

  std::vector<Kept> kept;
  int builds = 0;
  std::vector<PacketShadows> shadows = { {} }; ///< The lattices of each material.
  PacketSky sky = {};
  std::vector<std::vector<double>> sums; ///< ExtinctionSums of each optical table.
  Fingerprint sumInputs;
  FloatTable directions; ///< Table that shaders read; empty without ambient occlusion.
};

}

#endif
