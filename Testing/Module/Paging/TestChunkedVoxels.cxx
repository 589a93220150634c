// Voxels of a volume in chunks that are read when they are needed, because they do not fit in
// memory.

#include "Module/Paging/PagesInMemory.h"
#include "Module/Paging/VoxelsInChunks.h"
#include "Module/Scenes/MapperScene.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkStringArray.h>

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <random>
#include <thread>
#include <vector>

using namespace varimarch;

namespace
{

TEST_F(VoxelsInChunks, AreThoseOfTheChunks)
{
  for (const Shape& shape : { uneven, even })
  {
    const vtkSmartPointer<vtkImageData> torso = Torso(shape);
    vtkImageData* const image = this->Read(this->WriteZarr(torso, shape));
    ASSERT_STREQ(this->reader->GetErrorMessage(), "");
    ASSERT_TRUE(this->reader->HasVoxelsOnDisk());
    const short* const expected = Voxels(torso);
    const vtkIdType count = torso->GetNumberOfPoints();
    ASSERT_EQ(image->GetNumberOfPoints(), count);
    EXPECT_TRUE(std::equal(expected, expected + count, Voxels(image)));
    std::filesystem::remove_all(this->folder.Path("a.zarr"));
  }
}

TEST_F(VoxelsInChunks, AreReadByThreadsThatTouchThemAnywhere)
{
  constexpr vtkIdType EnoughForTwoReaders = 5000000;
  const vtkSmartPointer<vtkImageData> torso = Torso(uneven);
  vtkImageData* const image = this->Read(this->WriteZarr(torso, uneven), EnoughForTwoReaders);
  ASSERT_TRUE(this->reader->HasVoxelsOnDisk());
  const auto differ = [&](unsigned seed)
  {
    std::mt19937 random(seed);
    std::uniform_int_distribution<vtkIdType> places(0, torso->GetNumberOfPoints() - 1);
    int count = 0;
    for (int i = 0; i < 500; ++i)
    {
      const vtkIdType place = places(random);
      count += Voxels(image)[place] == Voxels(torso)[place] ? 0 : 1;
    }
    return count;
  };
  std::array<int, 4> counts = {};
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < counts.size(); ++i)
  {
    threads.emplace_back([&, i] { counts[i] = differ(i); });
  }
  std::for_each(threads.begin(), threads.end(), [](std::thread& thread) { thread.join(); });
  EXPECT_EQ(counts, (std::array<int, 4>{}));
}

TEST_F(VoxelsInChunks, HaveTheFillValueWhereNoChunkIs)
{
  const vtkSmartPointer<vtkImageData> torso = Torso(uneven);
  for (const int fill : { 0, -1024 })
  {
    this->WriteZarr(torso, uneven, fill);
    for (int j = 1; j < 5; ++j)
    {
      for (int i = 0; i < 7; ++i)
      {
        std::filesystem::remove(this->folder.Path(this->ChunkOf({ i, j, 3 })));
      }
    }
    vtkNew<vtkImageData> whole;
    whole->DeepCopy(this->Read(this->folder.Path("a.zarr"), 0));
    ASSERT_FALSE(this->reader->HasVoxelsOnDisk());
    const std::vector<short> expected(Voxels(whole), Voxels(whole) + whole->GetNumberOfPoints());
    vtkImageData* const image = this->Read(this->folder.Path("a.zarr"));
    ASSERT_TRUE(this->reader->HasVoxelsOnDisk());
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), Voxels(image))) << fill;
    EXPECT_EQ(MapperScene(image).DrawByProcessor(), MapperScene(whole).DrawByProcessor()) << fill;
    EXPECT_GT(std::count(expected.begin(), expected.end(), short(fill)), 203 * 64 * 8 - 1);
    vtkStringArray* const warnings = this->reader->GetWarnings();
    EXPECT_EQ(warnings->GetValue(warnings->GetNumberOfValues() - 1).find("28 chunks are not"), 0u);
  }
}

TEST_F(VoxelsInChunks, LookExactlyAsFromMemory)
{
  const vtkSmartPointer<vtkImageData> torso = Torso(uneven);
  const std::string path = this->WriteZarr(torso, uneven);
  vtkNew<vtkImageData> inMemory;
  inMemory->DeepCopy(this->Read(path, 0));
  ASSERT_FALSE(this->reader->HasVoxelsOnDisk());
  MapperScene memory(inMemory);
  const std::vector<float> expected = memory.DrawByProcessor();
  MapperScene disk(this->Read(path));
  ASSERT_TRUE(this->reader->HasVoxelsOnDisk());
  EXPECT_GT(*std::max_element(expected.begin(), expected.end()), 0.1);
  EXPECT_EQ(disk.DrawByProcessor(), expected);
}

TEST_F(VoxelsInChunks, OfADamagedChunkAreReportedOnceAndCountAsZero)
{
  const vtkSmartPointer<vtkImageData> torso = Torso(uneven);
  MapperScene scene(this->Read(this->WriteZarr(torso, uneven)));
  ASSERT_TRUE(this->reader->HasVoxelsOnDisk());
  this->folder.Write(this->ChunkOf({ 3, 2, 4 }), "half");
  const ExpectedVtkErrors errors;
  scene.DrawByProcessor();
  scene.DrawByProcessor();
  EXPECT_EQ(errors.Messages().size(), 1u) << errors.Text();
  EXPECT_NE(errors.Text().find("4.2.3"), std::string::npos) << errors.Text();
  EXPECT_NE(errors.Text().find("count as 0"), std::string::npos) << errors.Text();
  const vtkIdType inside = (vtkIdType(36) * 89 + 40) * 203 + 100;
  EXPECT_EQ(Voxels(scene.image)[inside], 0);
}

TEST_F(VoxelsInChunks, OfAChunkThatIsGoneAreReportedAndCountAsZero)
{
  const vtkSmartPointer<vtkImageData> torso = Torso(uneven);
  vtkImageData* const image = this->Read(this->WriteZarr(torso, uneven, -1024));
  ASSERT_TRUE(this->reader->HasVoxelsOnDisk());
  MapperScene scene(image);
  std::filesystem::remove(this->folder.Path(this->ChunkOf({ 3, 2, 4 })));
  const ExpectedVtkErrors errors;
  scene.DrawByProcessor();
  EXPECT_NE(errors.Text().find("1 of them gone"), std::string::npos) << errors.Text();
  const vtkIdType inside = (vtkIdType(36) * 89 + 40) * 203 + 100;
  EXPECT_EQ(Voxels(image)[inside], 0);
}

TEST_F(VoxelsInChunks, ThatWereWrittenStay)
{
  vtkImageData* const image = this->Read(this->WriteZarr(Torso(uneven), uneven));
  ASSERT_TRUE(this->reader->HasVoxelsOnDisk());
  auto* const voxels = static_cast<volatile short*>(image->GetScalarPointer());
  for (const vtkIdType place : { 5, 500000 })
  {
    voxels[place] = 12345;
    std::this_thread::sleep_for(std::chrono::milliseconds(50)); // long enough for some drops
    EXPECT_EQ(voxels[place], 12345);
  }
}

// Each thread writes to voxels of its own, in pages that others read and that are dropped.
TEST_F(VoxelsInChunks, ThatThreadsWriteStayWhileOthersAreDropped)
{
  constexpr int Threads = 4;
  constexpr int AccessesPerWrite = 25;
  const vtkSmartPointer<vtkImageData> torso = Torso(uneven);
  vtkImageData* const image = this->Read(this->WriteZarr(torso, uneven));
  ASSERT_TRUE(this->reader->HasVoxelsOnDisk());
  const vtkIdType count = torso->GetNumberOfPoints();
  auto* const expected = static_cast<short*>(torso->GetScalarPointer());
  auto* const voxels = static_cast<volatile short*>(image->GetScalarPointer());
  std::array<int, Threads> wrong = {};
  const auto use = [&](int thread)
  {
    std::mt19937 random{ unsigned(thread) };
    std::uniform_int_distribution<vtkIdType> places(0, count / Threads - 1);
    for (int i = 1; i <= 10 * AccessesPerWrite; ++i)
    {
      const vtkIdType place = Threads * places(random) + thread;
      if (i % AccessesPerWrite == 0)
      {
        expected[place] = short(10000 + i);
        voxels[place] = expected[place];
      }
      wrong[thread] += voxels[place] == expected[place] ? 0 : 1;
    }
  };
  std::vector<std::thread> threads;
  for (int i = 0; i < Threads; ++i)
  {
    threads.emplace_back(use, i);
  }
  std::for_each(threads.begin(), threads.end(), [](std::thread& thread) { thread.join(); });
  EXPECT_EQ(wrong, (std::array<int, Threads>{}));
  EXPECT_TRUE(std::equal(expected, expected + count, Voxels(image)));
}

TEST_F(VoxelsInChunks, OfPagesOfZerosStayWithoutMemory)
{
  const vtkSmartPointer<vtkImageData> needle = Needle(even);
  vtkImageData* const image = this->Read(this->WriteZarr(needle, even));
  ASSERT_TRUE(this->reader->HasVoxelsOnDisk());
  auto* const voxels = static_cast<volatile short*>(image->GetScalarPointer());
  const vtkIdType count = image->GetNumberOfPoints();
  for (int round = 0; round < 2; ++round)
  {
    // Pages that were dropped are read again, those of zeros are there. The newest units stay.
    EXPECT_TRUE(std::equal(Voxels(needle), Voxels(needle) + count, Voxels(image)));
    std::this_thread::sleep_for(std::chrono::milliseconds(50)); // long enough for some drops
    const auto pageBytes = std::size_t(getpagesize());
    const std::size_t pages = std::size_t(count) * sizeof(short) / pageBytes;
    const auto others = std::size_t(even.size[2]);
    EXPECT_GE(PagesThere(image), pages - others);
    EXPECT_LT(PagesThere(image), pages);
    EXPECT_LT(MemoryOfMapping(image), others * pageBytes);
  }
  // A page of zeros is written, and the unit that it is in dropped and read again.
  const vtkIdType pageBehind = Middle(even, 0) + 8 * even.size[0];
  voxels[pageBehind] = 12345;
  EXPECT_TRUE(
    std::equal(Voxels(needle) + count / 2, Voxels(needle) + count, Voxels(image) + count / 2));
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(voxels[Middle(even, 0)], 700);
  EXPECT_EQ(voxels[pageBehind], 12345);
}

TEST_F(VoxelsInChunks, OfChunksOfZerosAreNotRead)
{
  const vtkSmartPointer<vtkImageData> needle = Needle(even);
  vtkImageData* const image = this->Read(this->WriteZarr(needle, even));
  ASSERT_TRUE(this->reader->HasVoxelsOnDisk());
  MapperScene scene(image);
  this->folder.Write(this->ChunkOf({ 0, 2, 4 }), "half"); // in a row with chunks of other voxels
  this->folder.Write(this->ChunkOf({ 1, 0, 4 }), "half"); // in a row of zeros
  const vtkIdType count = image->GetNumberOfPoints();
  EXPECT_TRUE(std::equal(Voxels(needle), Voxels(needle) + count, Voxels(image)));
  scene.DrawByProcessor(); // reports no error
}

TEST_F(VoxelsInChunks, HaveNewRangesAfterAChunkWasWritten)
{
  const vtkSmartPointer<vtkImageData> torso = Torso(uneven);
  const std::string path = this->WriteZarr(torso, uneven);
  this->Read(path);
  const std::string made = this->folder.Bytes("a.zarr.0.0.0.varimarch-ranges");
  this->Read(path);
  EXPECT_EQ(this->folder.Bytes("a.zarr.0.0.0.varimarch-ranges"), made);
  torso->SetScalarComponentFromDouble(0, 0, 0, 0, 30000.0);
  this->WriteChunk(torso, uneven, { 0, 0, 0 });
  this->Read(path);
  EXPECT_NE(this->folder.Bytes("a.zarr.0.0.0.varimarch-ranges"), made);
}

TEST_F(VoxelsInChunks, AreStillReadAfterAForkedProcessReleasedThem)
{
  const vtkSmartPointer<vtkImageData> torso = Torso(uneven);
  vtkImageData* const image = this->Read(this->WriteZarr(torso, uneven));
  ASSERT_TRUE(this->reader->HasVoxelsOnDisk());
  const pid_t child = fork();
  if (child == 0)
  {
    alarm(60); // ends it if it waits for a thread that it does not have
    image->ReleaseData();
    _exit(0);
  }
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(std::equal(Voxels(torso), Voxels(torso) + torso->GetNumberOfPoints(), Voxels(image)));
}

// Chunks of several times may have the same sizes and times of change.
TEST_F(VoxelsInChunks, HaveRangesForEachTime)
{
  namespace fs = std::filesystem;
  this->WriteZarr(Torso(even), even);
  this->folder.Write("t.zarr/.zattrs",
    R"({"multiscales": [{"version": "0.4", "datasets": [{"path": "0"}], "axes": [
    {"name": "t", "type": "time"}, {"name": "z", "type": "space"}, {"name": "y", "type": "space"},
    {"name": "x", "type": "space"}]}]})");
  this->folder.Write("t.zarr/0/.zarray",
    R"({"zarr_format": 2, "shape": [2, 72, 64, 256], "chunks": [1, 8, 16, 64], "dtype": "<i2",
    "compressor": null, "order": "C", "filters": null, "fill_value": 0})");
  const auto now = fs::file_time_type::clock::now();
  for (const auto& chunk : fs::directory_iterator(this->folder.Path("a.zarr")))
  {
    const std::string name = chunk.path().filename().string();
    if (name == ".zarray")
    {
      continue;
    }
    const std::string bytes = this->folder.Bytes("a.zarr/" + name);
    fs::last_write_time(this->folder.Write("t.zarr/0/0." + name, bytes), now);
    const std::string zeros(bytes.size(), '\0');
    fs::last_write_time(this->folder.Write("t.zarr/0/1." + name, zeros), now);
  }
  for (const int time : { 0, 1 })
  {
    this->reader->SetTimeIndex(time);
    this->Read(this->folder.Path("t.zarr"));
    ASSERT_TRUE(this->reader->HasVoxelsOnDisk());
  }
  EXPECT_NE(this->folder.Bytes("t.zarr.0.0.0.varimarch-ranges"),
    this->folder.Bytes("t.zarr.0.0.1.varimarch-ranges"));
}

TEST_F(VoxelsInChunks, HaveACoarserLevelAsPreviewUntilTheirRangesAreMade)
{
  namespace fs = std::filesystem;
  constexpr Shape half = { { 128, 32, 36 }, { 64, 16, 8 } };
  for (const Shape& shape : { even, half })
  {
    this->WriteZarr(Torso(shape), shape);
    fs::create_directories(this->folder.Path("p.zarr"));
    fs::rename(this->folder.Path("a.zarr"),
      this->folder.Path(shape.size == half.size ? "p.zarr/1" : "p.zarr/0"));
  }
  this->folder.Write("p.zarr/.zattrs",
    R"({"multiscales": [{"version": "0.4", "axes": [{"name": "z", "type": "space"},
    {"name": "y", "type": "space"}, {"name": "x", "type": "space"}], "datasets": [
    {"path": "0", "coordinateTransformations": [{"type": "scale", "scale": [1, 1, 1]}]},
    {"path": "1", "coordinateTransformations": [{"type": "scale", "scale": [2, 2, 2]}]}]}]})");
  this->reader->PreviewAllowedOn();
  vtkImageData* const copy = this->Read(this->folder.Path("p.zarr"));
  ASSERT_STREQ(this->reader->GetErrorMessage(), "");
  EXPECT_TRUE(this->reader->IsPreview());
  EXPECT_TRUE(std::equal(half.size.begin(), half.size.end(), copy->GetDimensions()));
  const double spacingOfCopy = copy->GetSpacing()[0];
  this->reader->PreviewAllowedOff();
  EXPECT_EQ(2.0 * this->Read(this->folder.Path("p.zarr"))->GetSpacing()[0], spacingOfCopy);
  EXPECT_FALSE(this->reader->IsPreview());
  EXPECT_TRUE(this->reader->HasVoxelsOnDisk());
  this->reader->PreviewAllowedOn();
  this->Read(this->folder.Path("p.zarr"));
  EXPECT_FALSE(this->reader->IsPreview());
}

TEST_F(VoxelsInChunks, AreRefusedIfAnImageCannotNumberThem)
{
  // Products of these numbers are beyond 2^32 and 2^64.
  for (const char* const shape :
    { "[4611686018427387904, 4611686018427387904, 4611686018427387904]",
      "[2147483647, 2147483647, 2147483647]", "[1, 1, 8589934592]" })
  {
    this->folder.Write("a.zarr/.zarray",
      std::string(R"({"zarr_format": 2, "shape": )") + shape +
        R"(, "chunks": [8, 8, 8], "dtype": "<i2", "compressor": null, "order": "C",
        "filters": null, "fill_value": 0})");
    const ExpectedVtkErrors errors;
    this->Read(this->folder.Path("a.zarr"), vtkIdType(1) << 50);
    EXPECT_NE(std::string(this->reader->GetErrorMessage()), "") << shape;
  }
}

TEST_F(VoxelsInChunks, AreRefusedWithTheObstacleIfTheyNeitherFitNorCanStay)
{
  const Shape oneChunk = { uneven.size, uneven.size };
  const std::string path = this->WriteZarr(Torso(oneChunk), oneChunk);
  const ExpectedVtkErrors errors;
  this->Read(path);
  EXPECT_NE(std::string(this->reader->GetErrorMessage()).find("are in chunks of which a row needs"),
    std::string::npos)
    << this->reader->GetErrorMessage();
}

}
