// Boxes of a volume in levels, as those who draw volumes larger than memory read them.
#include "PhantomLibraryFiles.h"

#include "Readers/Decoder/DecodedPyramid.h"

#include <vtkType.h>

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

namespace
{

using varimarch::BrickSource;
using varimarch::DecodedPyramid;

/// Writes the phantom as OME-Zarr of one level, and opens it.
std::unique_ptr<DecodedPyramid> Opened(const TemporaryFolder& folder, const StoredVolume& volume)
{
  folder.Write("a.zarr/.zattrs", OmeZarrText(volume));
  folder.Write("a.zarr/0/.zarray", ZarrArrayText(volume, R"({"id": "blosc"})"));
  folder.Write("a.zarr/0/0.0.0", Blosced(VoxelBytes(volume), "lz4"));
  varimarch::ReadProgress silent([](double) { return true; });
  return varimarch::OpenPyramidAt(folder.Path("a.zarr"), {}, silent);
}

/// A box of 3 x 2 x 2 voxels inside the phantom.
constexpr BrickSource::Box inner = { { 1, 1, 1 }, { 4, 3, 3 } };

template <class Number>
void ExpectInner(const StoredVolume& volume, const std::vector<Number>& voxels)
{
  const auto& size = volume.dimensions;
  std::size_t place = 0;
  for (int k = 1; k < 3; ++k)
  {
    for (int j = 1; j < 3; ++j)
    {
      for (int i = 1; i < 4; ++i, ++place)
      {
        const std::size_t voxel = std::size_t((k * size[1] + j) * size[0] + i);
        EXPECT_EQ(double(voxels[place]), volume.values[voxel]) << i << ' ' << j << ' ' << k;
      }
    }
  }
}

TEST(Pyramids, GiveTheVoxelsOfABoxWithXFastest)
{
  const TemporaryFolder folder;
  const StoredVolume volume = phantom::Stored(0);
  const auto pyramid = Opened(folder, volume);
  ASSERT_TRUE(pyramid);
  ASSERT_EQ(pyramid->Levels().size(), 1u);
  EXPECT_EQ(pyramid->Levels()[0].dimensions, (std::array<std::int64_t, 3>{ 5, 4, 3 }));
  ASSERT_EQ(pyramid->Type(), varimarch::VoxelType::Int16);
  std::vector<short> voxels(12);
  pyramid->Read(0, inner, voxels.data());
  ExpectInner(volume, voxels);
}

TEST(Pyramids, GiveFloatsForTypesThatPacketsDoNotRead)
{
  const TemporaryFolder folder;
  StoredVolume volume = phantom::Stored(0);
  volume.scalarType = VTK_UNSIGNED_INT;
  const auto pyramid = Opened(folder, volume);
  ASSERT_TRUE(pyramid);
  ASSERT_EQ(pyramid->Type(), varimarch::VoxelType::Float32);
  std::vector<float> voxels(12);
  pyramid->Read(0, inner, voxels.data());
  ExpectInner(volume, voxels);
}

TEST(Pyramids, AreReadBySeveralThreadsAndOutliveThem)
{
  const TemporaryFolder folder;
  const StoredVolume volume = phantom::Stored(0);
  const auto pyramid = Opened(folder, volume);
  ASSERT_TRUE(pyramid);
  // The decoders that these threads start end with them.
  for (int round = 0; round < 2; ++round)
  {
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
    {
      threads.emplace_back(
        [&]
        {
          std::vector<short> voxels(12);
          pyramid->Read(0, inner, voxels.data());
          ExpectInner(volume, voxels);
        });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
  }
  std::vector<short> voxels(12);
  pyramid->Read(0, inner, voxels.data());
  ExpectInner(volume, voxels);
}

TEST(Pyramids, FailWithASentenceIfAChunkIsDamagedOrABoxIsOutside)
{
  const TemporaryFolder folder;
  const auto pyramid = Opened(folder, phantom::Stored(0));
  ASSERT_TRUE(pyramid);
  std::vector<short> voxels(60);
  EXPECT_THROW(pyramid->Read(0, { { 0, 0, 0 }, { 6, 1, 1 } }, voxels.data()), std::runtime_error);
  folder.Write("a.zarr/0/0.0.0", "damaged");
  try
  {
    pyramid->Read(0, inner, voxels.data());
    FAIL() << "the chunk was read";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("0.0.0"), std::string::npos) << error.what();
  }
}

TEST(Pyramids, FailIfTheFileLacksTheTime)
{
  const TemporaryFolder folder;
  const std::string path = folder.Path("a.ims");
  WriteHdf5(path, phantom::Stored(0), Hdf5Kind::Imaris);
  varimarch::ReadProgress silent([](double) { return true; });
  varimarch::ReadOptions options;
  EXPECT_TRUE(varimarch::OpenPyramidAt(path, options, silent));
  options.time = 1;
  EXPECT_THROW(varimarch::OpenPyramidAt(path, options, silent), std::runtime_error);
}

TEST(Pyramids, AreNotMadeOfOtherFormats)
{
  const TemporaryFolder folder;
  varimarch::ReadProgress silent([](double) { return true; });
  const std::string path = folder.Write("a.nii", NiftiBytes(phantom::Stored(0)));
  EXPECT_FALSE(varimarch::OpenPyramidAt(path, {}, silent));
}

}
