// Voxels of a volume in chunks that are read when they are needed, because they do not fit in
// memory.

#include "Module/MapperScene.h"
#include "Module/PhantomFiles.h"
#include "Scene/ProceduralVolume.h"
#include "Support/ExpectedVtkErrors.h"
#include "Support/UserFaults.h"

#include <vtkStringArray.h>
#include <vtkVolumeFileReader.h>

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

/// Memory in which the voxels do not fit. The program has more, so that what was read is dropped
/// again and again.
constexpr vtkIdType LessThanTheVoxels = 1200000;

/// The shape of a volume of shorts as Zarr, x first.
struct Shape
{
  std::array<int, 3> size;
  std::array<int, 3> chunk;
};

// The rows of a unit begin and end inside pages, and at their borders.
constexpr Shape uneven = { { 203, 89, 71 }, { 32, 16, 8 } };
constexpr Shape even = { { 256, 64, 72 }, { 64, 16, 8 } };

class VoxelsInChunks : public testing::Test
{
protected:
  void SetUp() override
  {
    if (!HasUserFaults())
    {
      GTEST_SKIP() << "the system refuses userfaultfd";
    }
  }

  static vtkSmartPointer<vtkImageData> Torso(const Shape& shape)
  {
    return ProceduralVolume({ ProceduralKind::Torso, shape.size, 7 });
  }

  static const short* Voxels(vtkImageData* image)
  {
    return static_cast<const short*>(image->GetScalarPointer());
  }

  std::string ChunkOf(const std::array<int, 3>& index) const
  {
    return "a.zarr/" + std::to_string(index[2]) + "." + std::to_string(index[1]) + "." +
      std::to_string(index[0]);
  }

  void WriteChunk(vtkImageData* image, const Shape& shape, const std::array<int, 3>& index)
  {
    const auto& chunk = shape.chunk;
    std::vector<short> voxels;
    for (int i = 0; i < chunk[0] * chunk[1] * chunk[2]; ++i)
    {
      const std::array<int, 3> at = { index[0] * chunk[0] + i % chunk[0],
        index[1] * chunk[1] + i / chunk[0] % chunk[1],
        index[2] * chunk[2] + i / (chunk[0] * chunk[1]) };
      const bool isInside = at[0] < shape.size[0] && at[1] < shape.size[1] && at[2] < shape.size[2];
      voxels.push_back(isInside
          ? Voxels(image)[(vtkIdType(at[2]) * shape.size[1] + at[1]) * shape.size[0] + at[0]]
          : short(0));
    }
    this->folder.Write(
      this->ChunkOf(index), { reinterpret_cast<const char*>(voxels.data()), 2 * voxels.size() });
  }

  std::string WriteZarr(vtkImageData* image, const Shape& shape, int fill = 0)
  {
    const auto text = [](const std::array<int, 3>& sizes)
    {
      return "[" + std::to_string(sizes[2]) + ", " + std::to_string(sizes[1]) + ", " +
        std::to_string(sizes[0]) + "]";
    };
    this->folder.Write("a.zarr/.zarray",
      R"({"zarr_format": 2, "shape": )" + text(shape.size) + R"(, "chunks": )" + text(shape.chunk) +
        R"(, "dtype": "<i2", "compressor": null, "order": "C", "filters": null, "fill_value": )" +
        std::to_string(fill) + "}");
    for (int k = 0; k * shape.chunk[2] < shape.size[2]; ++k)
    {
      for (int j = 0; j * shape.chunk[1] < shape.size[1]; ++j)
      {
        for (int i = 0; i * shape.chunk[0] < shape.size[0]; ++i)
        {
          this->WriteChunk(image, shape, { i, j, k });
        }
      }
    }
    return this->folder.Path("a.zarr");
  }

  vtkImageData* Read(const std::string& path, vtkIdType memory = LessThanTheVoxels)
  {
    this->reader->SetFileName(path.c_str());
    this->reader->SetMaximumHostMemory(memory);
    this->reader->Modified();
    this->reader->Update();
    return this->reader->GetOutput();
  }

  TemporaryFolder folder;
  vtkNew<vtkVolumeFileReader> reader;
};

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
  const vtkSmartPointer<vtkImageData> torso = Torso(uneven);
  vtkImageData* const image = this->Read(this->WriteZarr(torso, uneven));
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
