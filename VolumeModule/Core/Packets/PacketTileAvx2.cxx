// Compiled for processors with AVX2 and FMA, so that nothing here may be called on others, and no
// function of other headers may come from here: those would get it too.

#include "Core/Packets/PacketTile.h"

#include "Core/Packets/PacketBoxes.h"
#include "Core/Packets/PacketExtreme.h"
#include "Core/Packets/PacketIsosurfaces.h"
#include "Core/Packets/PacketLocation.h"
#include "Core/Packets/PacketMarchers.h"
#include "Core/Packets/PacketMixture.h"
#include "Core/Packets/PacketPieces.h"
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
FLATTENED PacketSum MarchVoxels(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  if (scene.rule == PacketRule::Voxels)
  {
    return MarchBoxValues<Voxel>(scene, rays, walk, before);
  }
  if (scene.mask.rows)
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
  if (scene.mask.rows)
  {
    return MarchMaterial<Voxels, LabelledMaterial>(scene, rays, walk, before);
  }
  return HeadLitMaterial::IsThatOf(scene)
    ? MarchMaterial<Voxels, HeadLitMaterial>(scene, rays, walk, before)
    : MarchMaterial<Voxels, PacketMaterial>(scene, rays, walk, before);
}

template <class Voxel>
PacketSum March(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  switch (scene.rule)
  {
    case PacketRule::Extreme:
      return MarchExtreme<CubicCells<Voxel>>(scene, rays, before);
    case PacketRule::ExtremeVoxel:
      return MarchExtreme<PacketBoxes<Voxel>>(scene, rays, before);
    case PacketRule::Isosurfaces:
      return MarchIsosurfaces<Voxel>(scene, rays, walk, before);
    case PacketRule::Voxels:
    case PacketRule::MaterialVoxels:
      return MarchVoxels<Voxel>(scene, rays, walk, before);
    default:
      return MarchSampled<PacketVoxels<Voxel>>(scene, rays, walk, before);
  }
}

PacketSum March(
  const PacketScene& scene, const PacketRays& rays, const PacketWalk& walk, const PacketSum& before)
{
  if (scene.volume.areOfSpline)
  {
    return MarchSampled<PacketSpline>(scene, rays, walk, before);
  }
  return ByVoxelType(scene.volume.type,
    [&](auto voxel) { return March<decltype(voxel)>(scene, rays, walk, before); });
}

// What is left of rays that are cropped, or masked. The packet's pixels begin at x and y.
PacketSum MarchLeft(
  const PacketScene& scene, const PacketRays& rays, const PacketSum& before, int x, int y)
{
  const auto marchWhole = [&](const PacketRays& piece, const PacketSum& sum)
  {
    const PacketWalk walk(scene, piece, x, y);
    return scene.constituent.isOfMixture ? MarchMixture(scene, piece, walk, sum, x, y)
                                         : March(scene, piece, walk, sum);
  };
  const auto march = [&](const PacketRays& piece, const PacketSum& sum)
  {
    return scene.gaps.texels ? MarchAroundGaps(scene, piece, sum, marchWhole)
                             : marchWhole(piece, sum);
  };
  const auto marchMasked = [&](const PacketRays& piece, const PacketSum& sum)
  {
    return scene.mask.texels ? MarchPieces<MaskedPieces>(scene, piece, sum, march)
                             : march(piece, sum);
  };
  return scene.cuts.crops ? MarchPieces<CroppedPieces>(scene, rays, before, marchMasked)
                          : marchMasked(rays, before);
}

bool IsOfExtreme(const PacketScene& scene)
{
  return scene.rule == PacketRule::Extreme || scene.rule == PacketRule::ExtremeVoxel;
}

// What rays have gathered, as it is seen.
PacketSum SeenOf(const PacketScene& scene, const PacketSum& march)
{
  if (IsOfExtreme(scene))
  {
    return SeenOfExtreme(scene, march);
  }
  return scene.rule == PacketRule::Projection ? SeenOfProjection(scene, march) : march;
}

PacketSum SumOf(const PacketScene& scene, const PacketRays& rays, int x, int y)
{
  const PacketSum nothing = IsOfExtreme(scene) ? NothingFound() : PacketSum();
  return SeenOf(scene, MarchLeft(scene, rays, nothing, x, y));
}

// Where rays first have an opacity, and whether they do.
Lanes4 LocatePacket(const PacketScene& scene, const PacketRays& rays, int x, int y)
{
  const PacketWalk walk(scene, rays, x, y);
  const auto march = [&](const PacketRays& piece, const PacketSum& before)
  { return MarchLeft(scene, piece, before, x, y); };
  const PacketLocation& location = scene.location;
  Lanes t = OpacityLocation(scene, rays, walk, location.opacity, march).Find();
  const LaneMask isRay = LaneMask(rays.enter < rays.exit);
  if (location.leastOpacity > 0.0f && Any(isRay & LaneMask(t == Never)))
  {
    const Lanes later = OpacityLocation(scene, rays, walk, location.leastOpacity, march).Find();
    t = Select(LaneMask(t == Never), later, t);
  }
  const LaneMask isShown = LaneMask(t < Never) | (isRay & AllInt(location.orExit ? -1 : 0));
  const Lanes3 place = rays.At(Min(t, rays.exit));
  const Lanes one = Select(isShown, All(1.0f), Lanes{});
  return { one * place.x, one * place.y, one * place.z, one };
}

Lanes4 ColorsOf(const PacketSum& sum)
{
  return { sum.color.x, sum.color.y, sum.color.z, 1.0f - sum.transmittance };
}

Lanes4 DrawPacket(const PacketScene& scene, int x, int y)
{
  if (!IsVisible(scene.depths, x, y))
  {
    return ColorsOf(PacketSum());
  }
  const PacketRays rays = RaysOf(scene, x, y);
  if (!Any(LaneMask(rays.enter < rays.exit)))
  {
    return ColorsOf(PacketSum());
  }
  return scene.location.opacity > 0.0f ? LocatePacket(scene, rays, x, y)
                                       : ColorsOf(SumOf(scene, rays, x, y));
}

// Those of the packet's pixels that are asked for.
void Store(const Lanes4& drawn, int x, int y, const Viewport& pixels, float* rgba)
{
  const Numbers red(drawn.x);
  const Numbers green(drawn.y);
  const Numbers blue(drawn.z);
  const Numbers opacity(drawn.w);
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
        Store(DrawPacket(scene, x, y), x, y, pixels, rgba);
      }
    }
  }
}

}
