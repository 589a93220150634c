// Packets of rays through more voxels than 32 bits can number.

#include "Unit/PacketPictures.h"

#include "Core/Quality/ImageError.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>

using namespace varimarch;

namespace
{

struct Unmap
{
  std::size_t bytes;
  void operator()(std::uint8_t* mapped) const { munmap(mapped, this->bytes); }
};

/// Voxels of 8 bits in a sparse file, all of them 0 at first. Pages that nobody touches are neither
/// on disk nor in memory.
class SparseVoxels
{
public:
  explicit SparseVoxels(glm::ivec3 count)
    : count(count)
    , file(std::tmpfile(), std::fclose)
  {
    const std::size_t bytes = std::size_t(count.x) * count.y * count.z;
    EXPECT_EQ(ftruncate(fileno(this->file.get()), off_t(bytes)), 0);
    void* const mapped =
      mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, fileno(this->file.get()), 0);
    EXPECT_NE(mapped, MAP_FAILED);
    this->voxels = { static_cast<std::uint8_t*>(mapped), Unmap{ bytes } };
  }

  /// Copies the voxels of the pictures so that their first one is at (0, 0, z).
  void Put(const PacketPictures& pictures, int z)
  {
    const glm::ivec3 size = PacketPictures::Dimensions;
    for (int row = 0; row < size.y * size.z; ++row)
    {
      const std::int16_t* const from = pictures.Grid().Row(row % size.y, row / size.y);
      std::copy_n(from, size.x,
        this->voxels.get() +
          (std::int64_t(z + row / size.y) * this->count.y + row % size.y) * this->count.x);
    }
  }

  PacketVolume Volume() const
  {
    return { this->voxels.get(), VoxelType::UInt8, false, this->count };
  }

private:
  glm::ivec3 count;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file;
  std::unique_ptr<std::uint8_t, Unmap> voxels{ nullptr, Unmap{ 0 } };
};

/// The same view of the box as if its first voxel were at (0, 0, z).
void MoveView(RayParameters& rays, float z)
{
  for (auto& start : rays.rayStartGrid)
  {
    start.z += z * start.w;
  }
  rays.nearPlaneGrid.w -= z * rays.nearPlaneGrid.z;
  rays.farPlaneGrid.w -= z * rays.farPlaneGrid.z;
  rays.boxLowerGrid.z += z;
  rays.boxUpperGrid.z += z;
}

class ManyVoxels : public testing::TestWithParam<InstructionSet>
{
protected:
  // Positions that are a thousand voxels away from 0 are rounded to 1/16384 of a voxel.
  void ExpectSamePictureAt(int z)
  {
    this->many.Put(this->pictures, z);
    for (const PacketRule rule : { PacketRule::Midpoint, PacketRule::Extreme })
    {
      PacketScene& scene = this->pictures.scene;
      const PacketScene before = scene;
      scene.rule = rule;
      const std::vector<float> expected = this->pictures.March(GetParam());
      EXPECT_GT(*std::max_element(expected.begin(), expected.end()), 0.3);
      scene.volume = this->many.Volume();
      MoveView(scene.rays, float(z));
      const std::vector<float> found = this->pictures.March(GetParam());
      scene = before;
      EXPECT_LT(CompareImages(found.data(), expected.data(), found.size() / 4).percentile999, 0.1);
    }
  }

  // 4.6 billion voxels: 2^31 of them are in front of slice 512, 2^32 in front of slice 1024.
  SparseVoxels many{ glm::ivec3(2048, 2048, 1100) };
  PacketPictures pictures;
};

TEST_P(ManyVoxels, LookTheSameAroundThe31stPowerOfTwo)
{
  this->ExpectSamePictureAt(512 - PacketPictures::Dimensions.z / 2);
}

TEST_P(ManyVoxels, LookTheSameAroundThe32ndPowerOfTwo)
{
  this->ExpectSamePictureAt(1024 - PacketPictures::Dimensions.z / 2);
}

INSTANTIATE_TEST_SUITE_P(
  InstructionSets, ManyVoxels, testing::ValuesIn(InstructionSetsOfProcessor()));

}
