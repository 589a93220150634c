// Compiled for processors with AVX2 and FMA, so that nothing here may be called on others, and no
// function of other headers may come from here: those would get it too.

#include "Core/Packets/PacketTile.h"

#include "Core/Packets/PacketBoxes.h"
#include "Core/Packets/PacketExtreme.h"
#include "Core/Packets/PacketIsosurfaces.h"
#include "Core/Packets/PacketMarchers.h"
#include "Core/Packets/PacketProjection.h"
#include "Core/Packets/PacketSpline.h"

namespace varimarch
{

namespace
{

// All that it calls is part of it, so that lanes stay in registers; not with the checks of a
// sanitizer, of which there would be so many that they take a compiler ten minutes.
#ifdef __SANITIZE_ADDRESS__
#define FLATTENED
#else
#define FLATTENED [[gnu::flatten]]
#endif

template <class Voxels, class Material>
FLATTENED PacketSum MarchMaterial(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk)
{
  return scene.rule == PacketRule::MaterialMidpoint
    ? MarchMaterialMidpoints<Voxels, Material>(scene, rays, walk)
    : MaterialMarch<Voxels, Material>(scene, rays, walk).March();
}

template <class Voxels>
FLATTENED PacketSum MarchValues(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk)
{
  return scene.rule == PacketRule::Midpoint ? MarchMidpoints<Voxels>(scene, rays, walk)
                                            : MarchPreIntegrated<Voxels>(scene, rays, walk);
}

template <class Cells>
FLATTENED PacketSum MarchExtreme(const PacketScene& scene, const PacketRays& rays)
{
  return ExtremeMarch<Cells>(scene, rays).March();
}

template <class Voxels>
FLATTENED PacketSum MarchProjection(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk)
{
  return ProjectionMarch<Voxels>(scene, rays, walk).March();
}

template <class Voxel>
FLATTENED PacketSum MarchVoxels(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk)
{
  if (scene.rule == PacketRule::Voxels)
  {
    return MarchBoxValues<Voxel>(scene, rays, walk);
  }
  return HeadLitMaterial::IsThatOf(scene)
    ? MarchBoxMaterials<Voxel, HeadLitMaterial>(scene, rays, walk)
    : MarchBoxMaterials<Voxel, PacketMaterial>(scene, rays, walk);
}

template <class Voxel>
FLATTENED PacketSum MarchIsosurfaces(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk)
{
  return IsosurfaceMarch<Voxel>(scene, rays, walk).March();
}

template <class Voxels>
PacketSum MarchSampled(const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk)
{
  if (scene.rule == PacketRule::Projection)
  {
    return MarchProjection<Voxels>(scene, rays, walk);
  }
  if (scene.rule == PacketRule::Midpoint || scene.rule == PacketRule::PreIntegrated)
  {
    return MarchValues<Voxels>(scene, rays, walk);
  }
  return HeadLitMaterial::IsThatOf(scene)
    ? MarchMaterial<Voxels, HeadLitMaterial>(scene, rays, walk)
    : MarchMaterial<Voxels, PacketMaterial>(scene, rays, walk);
}

template <class Voxel>
PacketSum March(const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk)
{
  switch (scene.rule)
  {
    case PacketRule::Extreme:
      return MarchExtreme<CubicCells<Voxel>>(scene, rays);
    case PacketRule::ExtremeVoxel:
      return MarchExtreme<PacketBoxes<Voxel>>(scene, rays);
    case PacketRule::Isosurfaces:
      return MarchIsosurfaces<Voxel>(scene, rays, walk);
    case PacketRule::Voxels:
    case PacketRule::MaterialVoxels:
      return MarchVoxels<Voxel>(scene, rays, walk);
    default:
      return MarchSampled<PacketVoxels<Voxel>>(scene, rays, walk);
  }
}

PacketSum March(const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk)
{
  if (scene.volume.areOfSpline)
  {
    return MarchSampled<PacketSpline>(scene, rays, walk);
  }
  switch (scene.volume.type)
  {
    case VoxelType::Int8:
      return March<std::int8_t>(scene, rays, walk);
    case VoxelType::UInt8:
      return March<std::uint8_t>(scene, rays, walk);
    case VoxelType::Int16:
      return March<std::int16_t>(scene, rays, walk);
    case VoxelType::UInt16:
      return March<std::uint16_t>(scene, rays, walk);
    case VoxelType::Float32:
      return March<float>(scene, rays, walk);
  }
  return {};
}

PacketSum MarchPacket(const PacketScene& scene, int x, int y)
{
  if (!IsVisible(scene.depths, x, y))
  {
    return {};
  }
  const PacketRays rays = RaysOf(scene, x, y);
  return Any(LaneMask(rays.enter < rays.exit)) ? March(scene, rays, PacketWalk(scene, rays, x, y))
                                               : PacketSum();
}

// Those of the packet's pixels that are asked for.
void Store(const PacketSum& sum, int x, int y, const Viewport& pixels, float* rgba)
{
  const Numbers red(sum.color.x);
  const Numbers green(sum.color.y);
  const Numbers blue(sum.color.z);
  const Numbers opacity(1.0f - sum.transmittance);
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    const int column = x + lane % PacketWidth - pixels.left;
    const int row = y + lane / PacketWidth - pixels.bottom;
    if (column >= 0 && column < pixels.width && row >= 0 && row < pixels.height)
    {
      float* const pixel = rgba + 4 * (std::ptrdiff_t(row) * pixels.width + column);
      pixel[0] = red.of[lane];
      pixel[1] = green.of[lane];
      pixel[2] = blue.of[lane];
      pixel[3] = opacity.of[lane];
    }
  }
}

}

void MarchTileByAvx2(
  const PacketScene& scene, const Viewport& pixels, const Viewport& tile, float* rgba)
{
  const int top = pixels.bottom + pixels.height;
  const int right = pixels.left + pixels.width;
  for (int y = tile.bottom; y < tile.bottom + tile.height && y < top; y += PacketHeight)
  {
    for (int x = tile.left; x < tile.left + tile.width && x < right; x += PacketWidth)
    {
      if (x + PacketWidth > pixels.left && y + PacketHeight > pixels.bottom)
      {
        Store(MarchPacket(scene, x, y), x, y, pixels, rgba);
      }
    }
  }
}

}
