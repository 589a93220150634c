#ifndef Varimarch_Core_Packets_Reach_LightOnPlaces_h
#define Varimarch_Core_Packets_Reach_LightOnPlaces_h

// The light that a volume lets through to places around it, such as those of opaque geometry.

#include "Core/Packets/Reach/DimmedMaterial.h"

#include <cstddef>

namespace varimarch
{

namespace
{

/// Places of a packet, one for each of its pixels [grid space].
struct PacketPlaces
{
  Lanes3 placeGrid;
  LaneMask mask; ///< the pixels that have one
};

inline PacketPlaces PlacesOfPacket(const PacketScene& scene, int x, int y)
{
  const PacketReceivers& receivers = scene.receivers;
  float numbers[4][LaneCount];
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    const int column = x + lane % PacketWidth - receivers.pixels.left;
    const int row = y + lane / PacketWidth - receivers.pixels.bottom;
    const bool isInside =
      column >= 0 && column < receivers.pixels.width && row >= 0 && row < receivers.pixels.height;
    const std::ptrdiff_t pixel = std::ptrdiff_t(row) * receivers.pixels.width + column;
    for (int i = 0; i < 4; ++i)
    {
      numbers[i][lane] = isInside ? receivers.places[pixel][i] : 0.0f;
    }
  }
  return { { LanesAt(numbers[0]), LanesAt(numbers[1]), LanesAt(numbers[2]) },
    LaneMask(LanesAt(numbers[3]) > 0.0f) };
}

/// The parts of four lights that reach the places of a packet.
/// @param partOf  (index of a light, places) -> its part
template <class PartOf>
Lanes4 LightOnPlaces(const PacketScene& scene, const PacketPlaces& places, PartOf partOf)
{
  const auto lightOf = [&](int i)
  {
    const int light = scene.receivers.firstLight + i;
    return light < ShadowedLight::CountOf(scene) && Any(places.mask) ? partOf(light, places)
                                                                     : All(1.0f);
  };
  return { lightOf(0), lightOf(1), lightOf(2), lightOf(3) };
}

}

}

#endif
