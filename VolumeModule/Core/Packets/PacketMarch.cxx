#include "Core/Packets/PacketMarch.h"

#include "Core/Blocks/ReadingGate.h"
#include "Core/Packets/PacketTile.h"
#include "Core/Quality/MarchWork.h"

#include <glm/vec2.hpp>
#include <tbb/parallel_for.h>

#include <atomic>
#include <functional>

namespace varimarch
{

namespace
{

// Pixels along each side of what one core marches at a time: few enough that all cores finish
// together, and a multiple of a packet's.
constexpr glm::ivec2 TileSize = glm::ivec2(16);
// The same of a packet.
constexpr glm::ivec2 PacketSize = glm::ivec2(4, 2);

using TileMarch = void(
  const PacketScene& scene, const Viewport& pixels, const Viewport& tile, float* rgba);

TileMarch* TileMarchOf(const PacketScene& scene, [[maybe_unused]] InstructionSet set)
{
#ifdef VARIMARCH_PACKETS_FOR_AVX2
  if (set == InstructionSet::Avx2)
  {
    return IsOfOneType(scene)
      ? ByVoxelType(scene.volume.type,
          [](auto voxel) -> TileMarch* { return MarchTile<InstructionSet::Avx2, decltype(voxel)>; })
      : MarchTile<InstructionSet::Avx2, Anything>;
  }
#endif
  return MarchTile<InstructionSet::Baseline, Anything>;
}

InstructionSet FastestSet()
{
  static const InstructionSet fastest = InstructionSetsOfProcessor().front();
  return fastest;
}

// Tiles are counted from the image's first pixel: a pixel is then always in the same packet,
// whatever part of the image is marched. Cores take them in turn, so that they read voxels that lie
// together, and wait between two packets while too many voxels are in memory.
void ForEachPacket(const Viewport& pixels, const glm::ivec2& size, MarchWork* work,
  const std::function<void(const Viewport& packet)>& march)
{
  const glm::ivec2 begin(pixels.left, pixels.bottom);
  const glm::ivec2 first = begin / size;
  const glm::ivec2 count =
    (begin + glm::ivec2(pixels.width, pixels.height) + size - 1) / size - first;
  if (work)
  {
    const glm::ivec2 packetsOfTile = size / PacketSize;
    work->Begin(count.x * count.y * packetsOfTile.x * packetsOfTile.y);
  }
  std::atomic<int> next = 0;
  tbb::parallel_for(0, count.x * count.y,
    [&](int)
    {
      const int tile = next++;
      const glm::ivec2 at = (first + glm::ivec2(tile % count.x, tile / count.x)) * size;
      for (int y = at.y; y < at.y + size.y; y += PacketSize.y)
      {
        for (int x = at.x; x < at.x + size.x; x += PacketSize.x)
        {
          if (work && work->IsStopped())
          {
            return;
          }
          ReadingGate::OfProcess().Pass();
          march({ x, y, PacketSize.x, PacketSize.y });
          if (work)
          {
            work->EndPacket();
          }
        }
      }
    });
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

void MarchPackets(const PacketScene& scene, const Viewport& pixels, float* rgba, InstructionSet set,
  MarchWork* work)
{
  TileMarch* const march = TileMarchOf(scene, set);
  ForEachPacket(
    pixels, TileSize, work, [&](const Viewport& packet) { march(scene, pixels, packet, rgba); });
}

void MarchPackets(const PacketScene& scene, const Viewport& pixels, float* rgba, MarchWork* work)
{
  MarchPackets(scene, pixels, rgba, FastestSet(), work);
}

}
