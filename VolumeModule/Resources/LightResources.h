#ifndef Varimarch_Resources_LightResources_h
#define Varimarch_Resources_LightResources_h

#include "Core/Fields/LightLattice.h"
#include "Core/Packets/PacketScene.h"
#include "Frame/MarchPlan.h"
#include "Resources/MaterialResources.h"

#include <vector>

namespace varimarch
{

/// The lattices of the lights that cast shadows in a volume, one for each light, which packets of
/// rays fill while they draw. A lattice is kept as long as its light, the volume and its opacities
/// stay, whatever the view. There are none without an error tolerance, and none where a voxel may
/// be all but opaque: shadows are then thinner than the cells of a lattice.
class LightResources
{
public:
  /// @throws std::runtime_error if there is no memory
  /// @param materials  the look of the volume
  void Update(const VolumeMarch& march, const MaterialResources& materials);

  /// The lattices, and how exactly shadows are computed.
  PacketShadows Shadows() const;

  void Release() { this->kept.clear(); }

private:
  /// The lattice of a light.
  struct Kept
  {
    std::vector<double> inputs; ///< Everything that its light depends on.
    LightLattice lattice;
  };

  Kept TakeKept(const std::vector<double>& inputs, const glm::ivec3& voxelCount);

  std::vector<Kept> kept; ///< In the order of the lights.
  PacketShadows shadows = {};
};

}

#endif
