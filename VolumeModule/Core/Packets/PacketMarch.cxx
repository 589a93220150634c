#include "Core/Packets/PacketMarch.h"

#include "Core/Packets/PacketTile.h"

#include <tbb/parallel_for.h>

namespace varimarch
{

namespace
{

// Pixels on a side of what one core marches at a time: few enough that all cores finish together,
// and a multiple of a packet's.
constexpr int TileSide = 16;

using TileMarch = void(
  const PacketScene& scene, const Viewport& pixels, const Viewport& tile, float* rgba);

template <InstructionSet Set>
TileMarch* TileMarchOf(const PacketScene& scene)
{
  if (scene.constituent.isOfMixture)
  {
    return MarchTile<Set, Mixture>;
  }
  if (scene.volume.areOfSpline)
  {
    return MarchTile<Set, SplineCoefficients>;
  }
  if (!IsIndexedBy32Bits(scene.volume.voxelCount))
  {
    return MarchTile<Set, ManyVoxels>;
  }
  switch (scene.volume.type)
  {
    case VoxelType::Int8:
      return MarchTile<Set, std::int8_t>;
    case VoxelType::UInt8:
      return MarchTile<Set, std::uint8_t>;
    case VoxelType::Int16:
      return MarchTile<Set, std::int16_t>;
    case VoxelType::UInt16:
      return MarchTile<Set, std::uint16_t>;
    case VoxelType::Float32:
      break;
  }
  return MarchTile<Set, float>;
}

TileMarch* TileMarchOf(const PacketScene& scene, [[maybe_unused]] InstructionSet set)
{
#ifdef VARIMARCH_PACKETS_FOR_AVX2
  if (set == InstructionSet::Avx2)
  {
    return TileMarchOf<InstructionSet::Avx2>(scene);
  }
#endif
  return TileMarchOf<InstructionSet::Baseline>(scene);
}

}

std::vector<InstructionSet> InstructionSetsOfProcessor()
{
#ifdef VARIMARCH_PACKETS_FOR_AVX2
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
  {
    return { InstructionSet::Avx2, InstructionSet::Baseline };
  }
#endif
  return { InstructionSet::Baseline };
}

void MarchPackets(const PacketScene& scene, const Viewport& pixels, float* rgba, InstructionSet set)
{
  // Tiles are counted from the image's first pixel: a pixel is then always in the same packet,
  // whatever part of the image is marched.
  const int firstColumn = pixels.left / TileSide;
  const int firstRow = pixels.bottom / TileSide;
  const int columns = (pixels.left + pixels.width + TileSide - 1) / TileSide - firstColumn;
  const int rows = (pixels.bottom + pixels.height + TileSide - 1) / TileSide - firstRow;
  TileMarch* const march = TileMarchOf(scene, set);
  tbb::parallel_for(0, columns * rows,
    [&](int tile)
    {
      const int left = (firstColumn + tile % columns) * TileSide;
      const int bottom = (firstRow + tile / columns) * TileSide;
      march(scene, pixels, { left, bottom, TileSide, TileSide }, rgba);
    });
}

void MarchPackets(const PacketScene& scene, const Viewport& pixels, float* rgba)
{
  static const InstructionSet fastest = InstructionSetsOfProcessor().front();
  MarchPackets(scene, pixels, rgba, fastest);
}

}
