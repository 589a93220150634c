#ifndef Varimarch_Core_Packets_PacketAnyMarch_h
#define Varimarch_Core_Packets_PacketAnyMarch_h

// The march through anything: volumes of any kind, with labels and dimmed light, and mixtures.

#include "Core/Packets/AnyVoxels.h"
#include "Core/Packets/DimmedMaterial.h"
#include "Core/Packets/Mixture.h"
#include "Core/Packets/PacketVolumeMarch.h"

namespace varimarch
{

namespace
{

template <>
struct MarchOf<Anything>
{
  using Voxels = AnyVoxels;
  using Boxes = AnyBoxes;

  static PacketSum Along(const PacketPiece& piece)
  {
    return piece.scene.constituent.isOfMixture
      ? MarchBehind(piece, 0, nullptr)
      : MarchByRule<Anything>(piece.scene, piece.rays, piece.walk, piece.before);
  }

  static PacketSum AlongMaterial(const PacketScene& scene, const PacketRays& rays,
    const PacketWalk& walk, const PacketSum& before)
  {
    return IsDimmed(scene)
      ? MarchMaterial<Voxels, DimmedMaterial<Voxels>>(scene, rays, walk, before)
      : MarchMaterial<Voxels, LabelledMaterial>(scene, rays, walk, before);
  }

  static PacketSum AlongBoxes(const PacketScene& scene, const PacketRays& rays,
    const PacketWalk& walk, const PacketSum& before)
  {
    return IsDimmed(scene)
      ? MarchDimmedBoxes<Boxes, DimmedMaterial<Boxes>>(scene, rays, walk, before)
      : MarchMaterialBoxes<Boxes, LabelledMaterial>(scene, rays, walk, before);
  }

  static Lanes4 LightOn(const PacketScene& scene, int x, int y)
  {
    return LightOnPlaces(scene, PlacesOfPacket(scene, x, y),
      [&](int light, const PacketPlaces& places)
      {
        return scene.constituent.isOfMixture
          ? LightThroughAll(scene, light).ThroughVolumes(places.placeGrid, places.mask)
          : TracedLight(scene, light).ThroughVolume(places.placeGrid, places.mask);
      });
  }

private:
  static bool IsDimmed(const PacketScene& scene)
  {
    return scene.light.castsShadows || scene.sky.strength > 0.0f;
  }
};

}

}

#endif
