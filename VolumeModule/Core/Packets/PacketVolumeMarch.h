#ifndef Varimarch_Core_Packets_PacketVolumeMarch_h
#define Varimarch_Core_Packets_PacketVolumeMarch_h

// One volume of one component along the rays of a packet: the march of each rule.

#include "Core/Packets/Flattened.h"
#include "Core/Packets/Interpolation/CubicSpline.h"
#include "Core/Packets/Interpolation/Linear.h"
#include "Core/Packets/March/Extreme.h"
#include "Core/Packets/March/Isosurfaces.h"
#include "Core/Packets/March/MaterialMidpoint.h"
#include "Core/Packets/March/MaterialSegments.h"
#include "Core/Packets/March/MaterialVoxels.h"
#include "Core/Packets/March/Midpoint.h"
#include "Core/Packets/March/OpaqueEnd.h"
#include "Core/Packets/March/PreIntegrated.h"
#include "Core/Packets/March/Projection.h"
#include "Core/Packets/March/RangeMean.h"
#include "Core/Packets/March/Voxels.h"
#include "Core/Packets/Material/Labelled.h"
#include "Core/Packets/PacketTile.h"
#include "Core/Packets/PacketTileMarch.h"
#include "Core/Packets/Reach/DimmedMaterial.h"
#include "Core/Packets/Reach/LightOnPlaces.h"

namespace varimarch
{

namespace
{

/// True if the volume dims its own light.
inline bool IsDimmed(const PacketScene& scene)
{
  return scene.light.castsShadows || scene.sky.strength > 0.0f;
}

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

template <class Voxel>
FLATTENED PacketSum MarchRangeMean(
  const PacketScene& scene, const PacketRays& rays, const PacketSum& before)
{
  return RangeMeanMarch<Voxel>(scene, rays, before).March();
}

template <class Voxel>
FLATTENED PacketSum MarchVoxels(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  if (scene.rule == PacketRule::Voxels)
  {
    return MarchBoxValues<Voxel>(scene, rays, walk, before);
  }
  if (IsDimmed(scene))
  {
    return scene.labelRows
      ? MarchDimmedBoxes<Voxel, DimmedMaterial<PacketBoxes<Voxel>, LabelledMaterial>>(
          scene, rays, walk, before)
      : MarchDimmedBoxes<Voxel, DimmedMaterial<PacketBoxes<Voxel>, PacketMaterial>>(
          scene, rays, walk, before);
  }
  if (scene.labelRows)
  {
    return MarchBoxMaterials<Voxel, LabelledMaterial>(scene, rays, walk, before);
  }
  return HeadLitMaterial::IsThatOf(scene)
    ? MarchBoxMaterials<Voxel, HeadLitMaterial>(scene, rays, walk, before)
    : MarchBoxMaterials<Voxel, PacketMaterial>(scene, rays, walk, before);
}

template <class Voxel>
FLATTENED PacketSum MarchIsosurfaces(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  return IsosurfaceMarch<Voxel>(scene, rays, walk, before).March();
}

/// @tparam Voxels  PacketVoxels or PacketSpline
template <class Voxels>
PacketSum MarchSampled(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  if (scene.rule == PacketRule::Projection)
  {
    return MarchProjection<Voxels>(scene, rays, walk, before);
  }
  if (scene.rule == PacketRule::Midpoint || scene.rule == PacketRule::PreIntegrated)
  {
    return MarchValues<Voxels>(scene, rays, walk, before);
  }
  if (IsDimmed(scene))
  {
    return scene.labelRows
      ? MarchMaterial<Voxels, DimmedMaterial<Voxels, LabelledMaterial>>(scene, rays, walk, before)
      : MarchMaterial<Voxels, DimmedMaterial<Voxels, PacketMaterial>>(scene, rays, walk, before);
  }
  if (scene.labelRows)
  {
    return MarchMaterial<Voxels, LabelledMaterial>(scene, rays, walk, before);
  }
  return HeadLitMaterial::IsThatOf(scene)
    ? MarchMaterial<Voxels, HeadLitMaterial>(scene, rays, walk, before)
    : MarchMaterial<Voxels, PacketMaterial>(scene, rays, walk, before);
}

/// @tparam Voxel  the type of the voxels
template <class Voxel>
PacketSum MarchByRule(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  switch (scene.rule)
  {
    case PacketRule::Extreme:
      return MarchExtreme<CubicCells<Voxel>>(scene, rays, before);
    case PacketRule::ExtremeVoxel:
      return MarchExtreme<PacketBoxes<Voxel>>(scene, rays, before);
    case PacketRule::RangeMean:
      return MarchRangeMean<Voxel>(scene, rays, before);
    case PacketRule::Isosurfaces:
      return MarchIsosurfaces<Voxel>(scene, rays, walk, before);
    case PacketRule::Voxels:
    case PacketRule::MaterialVoxels:
      return MarchVoxels<Voxel>(scene, rays, walk, before);
    default:
      return scene.opaque.count > 0 ? MarchSampled<PacketVoxels<Voxel>>(scene,
                                        EndedByOpaque<Voxel>(scene, rays, walk), walk, before)
                                    : MarchSampled<PacketVoxels<Voxel>>(scene, rays, walk, before);
  }
}

template <class Voxel>
struct MarchOf
{
  static PacketSum Along(const PacketPiece& piece)
  {
    return MarchByRule<Voxel>(piece.scene, piece.rays, piece.walk, piece.before);
  }

  static Lanes4 LightOn(const PacketScene& scene, int x, int y)
  {
    const PacketPlaces places = PlacesOfPacket(scene, x, y);
    return scene.rule == PacketRule::MaterialVoxels
      ? LightOnPlaces<PacketBoxes<Voxel>>(scene, places)
      : LightOnPlaces<PacketVoxels<Voxel>>(scene, places);
  }
};

template <>
struct MarchOf<SplineCoefficients>
{
  static PacketSum Along(const PacketPiece& piece)
  {
    return MarchSampled<PacketSpline>(piece.scene, piece.rays, piece.walk, piece.before);
  }

  static Lanes4 LightOn(const PacketScene& scene, int x, int y)
  {
    return LightOnPlaces<PacketSpline>(scene, PlacesOfPacket(scene, x, y));
  }
};

}

}

#endif
