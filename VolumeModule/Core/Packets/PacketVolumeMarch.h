#ifndef Varimarch_Core_Packets_PacketVolumeMarch_h
#define Varimarch_Core_Packets_PacketVolumeMarch_h

// One volume of one component along the rays of a packet: the march of each rule.

#include "Core/Packets/BoxMarches.h"
#include "Core/Packets/Isosurfaces.h"
#include "Core/Packets/Lanes.h"
#include "Core/Packets/Materials.h"
#include "Core/Packets/OpaqueEnd.h"
#include "Core/Packets/PacketTile.h"
#include "Core/Packets/PacketTileMarch.h"
#include "Core/Packets/Projections.h"
#include "Core/Packets/SampledMarches.h"
#include "Core/Packets/Voxels.h"

namespace varimarch
{

namespace
{

template <class Voxels, class Material>
FLATTENED PacketSum MarchMaterial(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  return scene.rule == PacketRule::MaterialMidpoint
    ? MarchMaterialMidpoints<Voxels, Material>(scene, rays, walk, before)
    : MaterialMarch<Voxels, Material>(scene, rays, walk, before).March();
}

template <class Voxels>
FLATTENED PacketSum MarchValues(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  return scene.rule == PacketRule::Midpoint ? MarchMidpoints<Voxels>(scene, rays, walk, before)
                                            : MarchPreIntegrated<Voxels>(scene, rays, walk, before);
}

template <class Cells>
FLATTENED PacketSum MarchExtreme(
  const PacketScene& scene, const PacketRays& rays, const PacketSum& before)
{
  return ExtremeMarch<Cells>(scene, rays, before).March();
}

template <class Voxels>
FLATTENED PacketSum MarchProjection(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  return ProjectionMarch<Voxels>(scene, rays, walk, before).March();
}

template <class Voxels>
FLATTENED PacketSum MarchRangeMean(
  const PacketScene& scene, const PacketRays& rays, const PacketSum& before)
{
  return RangeMeanMarch<Voxels>(scene, rays, before).March();
}

template <class Boxes>
FLATTENED PacketSum MarchBoxes(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  return MarchBoxValues<Boxes>(scene, rays, walk, before);
}

template <class Boxes, class Material>
FLATTENED PacketSum MarchMaterialBoxes(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  return MarchBoxMaterials<Boxes, Material>(scene, rays, walk, before);
}

template <class Voxels>
FLATTENED PacketSum MarchIsosurfaces(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  return IsosurfaceMarch<Voxels>(scene, rays, walk, before).March();
}

template <class Content>
PacketSum MarchSampled(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  using Voxels = typename MarchOf<Content>::Voxels;
  switch (scene.rule)
  {
    case PacketRule::Projection:
      return MarchProjection<Voxels>(scene, rays, walk, before);
    case PacketRule::Midpoint:
    case PacketRule::PreIntegrated:
      return MarchValues<Voxels>(scene, rays, walk, before);
    default:
      return MarchOf<Content>::AlongMaterial(scene, rays, walk, before);
  }
}

/// Marches one volume.
template <class Content>
PacketSum MarchByRule(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  using Voxels = typename MarchOf<Content>::Voxels;
  using Boxes = typename MarchOf<Content>::Boxes;
  switch (scene.rule)
  {
    case PacketRule::Extreme:
      return MarchExtreme<CubicCells<Voxels>>(scene, rays, before);
    case PacketRule::ExtremeVoxel:
      return MarchExtreme<BoxCells<Boxes>>(scene, rays, before);
    case PacketRule::RangeMean:
      return MarchRangeMean<Voxels>(scene, rays, before);
    case PacketRule::Isosurfaces:
      return MarchIsosurfaces<Voxels>(scene, rays, walk, before);
    case PacketRule::Voxels:
      return MarchBoxes<Boxes>(scene, rays, walk, before);
    case PacketRule::MaterialVoxels:
      return MarchOf<Content>::AlongBoxes(scene, rays, walk, before);
    default:
      return scene.opaque.count > 0
        ? MarchSampled<Content>(scene, EndedByOpaque<Voxels>(scene, rays, walk), walk, before)
        : MarchSampled<Content>(scene, rays, walk, before);
  }
}

/// The march through voxels of one type, see IsOfOneType.
template <class Voxel>
struct MarchOf
{
  using Voxels = PacketVoxels<Voxel>;
  using Boxes = PacketBoxes<Voxel>;

  static PacketSum Along(const PacketPiece& piece)
  {
    return MarchByRule<Voxel>(piece.scene, piece.rays, piece.walk, piece.before);
  }

  static PacketSum AlongMaterial(const PacketScene& scene, const PacketRays& rays,
    const PacketWalk& walk, const PacketSum& before)
  {
    if (scene.labelRows)
    {
      return MarchMaterial<Voxels, LabelledMaterial>(scene, rays, walk, before);
    }
    return HeadLitMaterial::IsThatOf(scene)
      ? MarchMaterial<Voxels, HeadLitMaterial>(scene, rays, walk, before)
      : MarchMaterial<Voxels, PacketMaterial>(scene, rays, walk, before);
  }

  static PacketSum AlongBoxes(const PacketScene& scene, const PacketRays& rays,
    const PacketWalk& walk, const PacketSum& before)
  {
    if (scene.labelRows)
    {
      return MarchMaterialBoxes<Boxes, LabelledMaterial>(scene, rays, walk, before);
    }
    return HeadLitMaterial::IsThatOf(scene)
      ? MarchMaterialBoxes<Boxes, HeadLitMaterial>(scene, rays, walk, before)
      : MarchMaterialBoxes<Boxes, PacketMaterial>(scene, rays, walk, before);
  }

  /// Such scenes dim no light.
  static Lanes4 LightOn(const PacketScene&, int, int) { return {}; }
};

}

}

#endif
