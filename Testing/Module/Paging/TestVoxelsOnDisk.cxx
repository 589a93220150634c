// Voxels that stay in their file: the same values and images as from memory, within the memory that
// the program may use, and a message where the file loses them.

#include "Module/Files/PhantomFiles.h"
#include "Module/Files/VolumeRead.h"
#include "Module/Paging/TorsoOnDisk.h"
#include "Module/Scenes/MapperScene.h"

#include <vtkStringArray.h>
#include <vtkVolumeFileReader.h>
#include <vtkXMLWriter.h>

#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

namespace
{

/// Memory in which the phantom's voxels do not fit: they stay in the file, or are refused.
constexpr vtkIdType TooLittle = 60;

/// A NRRD header for the file that its voxels are in, or for those behind it at an even byte.
std::string NrrdHeader(const StoredVolume& volume, const std::string& dataFile = "")
{
  std::string header = NrrdHeaderText(volume) + "endian: little\nencoding: raw\n" +
    (dataFile.empty() ? "" : "data file: " + dataFile + "\n");
  header += header.size() % 2 == 0 ? "#\n" : "# \n";
  return header + (header.size() % 2 == 0 ? "# even\n\n" : "\n");
}

class VoxelsOnDisk : public TorsoOnDisk
{
protected:
  void ExpectMapped(const std::string& path)
  {
    const vtkSmartPointer<vtkImageData> image = this->Read(path, TooLittle);
    ASSERT_STREQ(this->reader->GetErrorMessage(), "") << path;
    EXPECT_TRUE(this->reader->HasVoxelsOnDisk()) << path;
    std::vector<double> values;
    vtkDataArray* const scalars = image->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < scalars->GetNumberOfValues(); ++i)
    {
      values.push_back(scalars->GetTuple1(i));
    }
    EXPECT_EQ(values, this->volume.values) << path;
    EXPECT_EQ(ReadVolumeAt(path).values, this->volume.values) << path;
  }

  const StoredVolume volume = phantom::Stored(0);
};

TEST_F(VoxelsOnDisk, AreThoseOfTheFileInEveryFormat)
{
  const std::string voxels = VoxelBytes(this->volume);
  const StoredVolume& v = this->volume;
  this->folder.Write("voxels.raw", voxels);
  this->ExpectMapped(this->folder.Write("attached.nrrd", NrrdHeader(v) + voxels));
  this->ExpectMapped(this->folder.Write("detached.nhdr", NrrdHeader(v, "voxels.raw")));
  this->ExpectMapped(
    this->folder.Write("image.mhd", MetaImageHeaderText(v) + "ElementDataFile = voxels.raw\n"));
  this->ExpectMapped(this->folder.Write("image.nii", NiftiBytes(v)));
  const VtiEncoding raw{ vtkXMLWriter::Appended, false, vtkXMLWriter::NONE, false, 64 };
  std::string vti = EncodedVti(v, voxels, raw);
  const std::size_t appended = vti.find("<AppendedData");
  const bool isEven = vti.find('_', appended) % 2 == 1; // the first byte is behind the mark
  vti.insert(appended, isEven ? 0 : 1, ' ');
  this->ExpectMapped(this->folder.Write("image.vti", vti));
}

TEST_F(VoxelsOnDisk, HaveACoarseCopyUntilTheyAreReadForTheFirstTime)
{
  constexpr vtkIdType LessThanFourTimesTheVoxels = 60000000;
  const int size[3] = { 301, 300, 200 }; // more than 2^24
  const auto valueAt = [](int x, int y, int z) { return std::uint8_t(7 * x + 13 * y + 31 * z); };
  std::string voxels;
  for (int i = 0; i < size[0] * size[1] * size[2]; ++i)
  {
    voxels += char(valueAt(i % size[0], i / size[0] % size[1], i / (size[0] * size[1])));
  }
  const std::string path = this->folder.Write("large.raw", voxels);
  this->reader->SetRawDimensions(size);
  this->reader->SetRawSpacing(1.0, 2.0, 3.0);
  this->reader->PreviewAllowedOn();
  vtkImageData* const copy = this->Read(path, LessThanFourTimesTheVoxels);
  ASSERT_STREQ(this->reader->GetErrorMessage(), "");
  ASSERT_TRUE(this->reader->IsPreview());
  EXPECT_FALSE(this->reader->HasVoxelsOnDisk());
  const std::string told = this->reader->GetWarnings()->GetValue(0);
  EXPECT_EQ(told.find("A coarse copy, 151 x 150 x 100 voxels"), 0u) << told;
  const std::array<double, 3> spacing = { 2.0, 4.0, 6.0 };
  EXPECT_TRUE(std::equal(spacing.begin(), spacing.end(), copy->GetSpacing()));
  for (const std::array<int, 3>& at :
    { std::array<int, 3>{ 0, 0, 0 }, { 150, 149, 99 }, { 17, 3, 90 } })
  {
    EXPECT_EQ(*static_cast<std::uint8_t*>(copy->GetScalarPointer(at[0], at[1], at[2])),
      valueAt(2 * at[0], 2 * at[1], 2 * at[2]));
  }
  const std::string ranges = path + ".varimarch-ranges";
  EXPECT_FALSE(std::filesystem::exists(ranges));
  for (const bool isAllowed : { false, true }) // the second time the ranges are there
  {
    this->reader->SetPreviewAllowed(isAllowed);
    this->Read(path, LessThanFourTimesTheVoxels);
    EXPECT_FALSE(this->reader->IsPreview());
    EXPECT_TRUE(this->reader->HasVoxelsOnDisk());
    EXPECT_EQ(this->reader->GetWarnings()->GetNumberOfValues(), 0);
  }
}

TEST_F(VoxelsOnDisk, HaveACoarseCopyInAQuarterOfTheMemoryHoweverSmallTheyAre)
{
  constexpr int Side = 50;
  const std::string path = this->folder.Write("small.raw", std::string(Side * Side * Side, 'v'));
  this->reader->SetRawDimensions(Side, Side, Side);
  this->reader->PreviewAllowedOn();
  for (const vtkIdType memory : { 2 * Side * Side * Side, 4 * Side * Side * Side - 1 })
  {
    const vtkIdType voxels = this->Read(path, memory)->GetNumberOfPoints();
    ASSERT_TRUE(this->reader->IsPreview());
    EXPECT_LE(voxels, memory / 4);
    this->reader->Modified();
  }
}

TEST_F(VoxelsOnDisk, AreReadIfTheyNeedLessThanAQuarterOfTheMemory)
{
  const std::string path =
    this->folder.Write("small.nrrd", NrrdHeader(this->volume) + VoxelBytes(this->volume));
  this->Read(path, vtkIdType(4 * 2 * this->volume.values.size()));
  EXPECT_FALSE(this->reader->HasVoxelsOnDisk());
  this->Read(path, vtkIdType(4 * 2 * this->volume.values.size() - 4));
  EXPECT_TRUE(this->reader->HasVoxelsOnDisk());
}

TEST_F(VoxelsOnDisk, AreRefusedWithTheObstacleIfTheyNeitherFitNorCanStay)
{
  const auto errorOf = [&](const std::string& path)
  {
    const ExpectedVtkErrors errors;
    this->Read(path, TooLittle);
    return std::string(this->reader->GetErrorMessage());
  };
  const StoredVolume& v = this->volume;
  const std::string header = NrrdHeaderText(v);
  const std::string packed = this->folder.Write(
    "packed.nrrd", header + "endian: little\nencoding: gzip\n\n" + Gzipped(VoxelBytes(v)));
  EXPECT_NE(errorOf(packed).find("that are compressed; store them"), std::string::npos);
  const std::string swapped = this->folder.Write(
    "swapped.nrrd", header + "endian: big\nencoding: raw\n\n" + VoxelBytes(v, true));
  EXPECT_NE(errorOf(swapped).find("another byte order"), std::string::npos);
  // They are read if they do fit.
  const vtkIdType bytes = vtkIdType(2 * v.values.size());
  EXPECT_EQ(this->Read(packed, bytes)->GetNumberOfPoints(), vtkIdType(v.values.size()));
  EXPECT_EQ(this->Read(swapped, bytes)->GetNumberOfPoints(), vtkIdType(v.values.size()));
}

TEST_F(VoxelsOnDisk, LookExactlyAsFromMemory)
{
  MapperScene memory(this->torso);
  vtkImageData* const onDisk = this->ReadTorso(this->WriteTorso());
  ASSERT_TRUE(this->reader->HasVoxelsOnDisk());
  onDisk->SetOrigin(this->torso->GetOrigin());
  MapperScene disk(onDisk);
  const std::vector<float> expected = memory.DrawByProcessor();
  EXPECT_GT(*std::max_element(expected.begin(), expected.end()), 0.1);
  EXPECT_EQ(disk.DrawByProcessor(), expected);
}

TEST_F(VoxelsOnDisk, ThatAreLostWhileTheyAreShownAreReportedOnce)
{
  const std::string path = this->WriteTorso();
  MapperScene scene(this->ReadTorso(path));
  scene.DrawByProcessor();
  std::filesystem::resize_file(path, 4096);
  const ExpectedVtkErrors errors;
  for (int frame = 0; frame < 2; ++frame)
  {
    scene.image->Modified(); // all voxels are read anew
    scene.DrawByProcessor();
  }
  EXPECT_EQ(errors.Messages().size(), 1u) << errors.Text();
  EXPECT_NE(errors.Text().find("was made shorter while it is drawn from disk"), std::string::npos);
  const auto* const last = static_cast<const short*>(scene.image->GetScalarPointer(39, 35, 23));
  EXPECT_EQ(*last, 0);
}

TEST_F(VoxelsOnDisk, HaveRangesThatAreKeptUntilTheyDoNotFit)
{
  const std::string path = this->WriteTorso();
  this->ReadTorso(path);
  const std::string made = this->folder.Bytes("torso.raw.varimarch-ranges");
  // A damaged file is made anew.
  std::string damaged = made;
  damaged[made.size() / 2] ^= 1;
  this->folder.Write("torso.raw.varimarch-ranges", damaged);
  this->reader->Modified();
  this->ReadTorso(path);
  EXPECT_EQ(this->folder.Bytes("torso.raw.varimarch-ranges"), made);
  // So is a file that belongs to other voxels.
  std::string voxels = this->folder.Bytes("torso.raw");
  voxels.back() = '\x55';
  this->folder.Write("torso.raw", voxels);
  this->reader->Modified();
  this->ReadTorso(path);
  EXPECT_NE(this->folder.Bytes("torso.raw.varimarch-ranges"), made);
}

// The check sum is right, so that only the value itself can tell.
TEST_F(VoxelsOnDisk, HaveNewRangesIfTheKeptOnesStateImpossibleExtremes)
{
  const std::string path = this->WriteTorso();
  this->ReadTorso(path);
  const std::string made = this->folder.Bytes("torso.raw.varimarch-ranges");
  std::string forged = made;
  const std::size_t begin = made.find('\n', made.find('\n') + 1) + 1;
  const double tooLarge = 1e9;
  std::memcpy(&forged[begin + sizeof(double)], &tooLarge, sizeof(double));
  const std::size_t end = made.size() - sizeof(uLong);
  const uLong sum = crc32_z(0, reinterpret_cast<const Bytef*>(&forged[begin]), end - begin);
  std::memcpy(&forged[end], &sum, sizeof(sum));
  this->folder.Write("torso.raw.varimarch-ranges", forged);
  this->reader->Modified();
  this->ReadTorso(path);
  EXPECT_EQ(this->folder.Bytes("torso.raw.varimarch-ranges"), made);
}

TEST_F(VoxelsOnDisk, HaveRangesThatNobodyElseMayReadIfTheVoxelsAreSo)
{
  using std::filesystem::perms;
  const std::string path = this->WriteTorso();
  std::filesystem::permissions(path, perms::owner_read | perms::owner_write);
  this->ReadTorso(path);
  const perms ofRanges = std::filesystem::status(path + ".varimarch-ranges").permissions();
  EXPECT_EQ(ofRanges, perms::owner_read | perms::owner_write);
}

TEST_F(VoxelsOnDisk, HaveRangesInTheFolderOfTheUserIfTheirOwnCannotBeWritten)
{
  std::filesystem::create_directory(this->folder.Path("torso.raw.varimarch-ranges"));
  std::filesystem::create_directory(this->folder.Path("torso.raw.varimarch-ranges/full"));
  setenv("XDG_CACHE_HOME", this->folder.Path("cache").c_str(), 1);
  this->ReadTorso(this->WriteTorso());
  unsetenv("XDG_CACHE_HOME");
  ASSERT_STREQ(this->reader->GetErrorMessage(), "");
  const std::filesystem::directory_iterator kept(this->folder.Path("cache/varimarch"));
  EXPECT_EQ(std::distance(begin(kept), end(kept)), 1);
}

TEST_F(VoxelsOnDisk, NeedMemoryForTheirBricks)
{
  const ExpectedVtkErrors errors;
  this->reader->SetRawDimensions(this->torso->GetDimensions());
  this->reader->SetRawScalarType(VTK_SHORT);
  this->Read(this->WriteTorso(), 20);
  EXPECT_NE(std::string(this->reader->GetErrorMessage()).find("for the bricks of 40 x 36 x 24"),
    std::string::npos)
    << this->reader->GetErrorMessage();
}

// Before the thread that watches the memory had an end of its own, this test did not end.
TEST_F(VoxelsOnDisk, CanBeReleasedWhileOthersAreRead)
{
  const std::string path = this->WriteTorso();
  constexpr int Repetitions = 200;
  for (int i = 0; i < Repetitions; ++i)
  {
    this->reader->Modified();
    this->ReadTorso(path);
    vtkNew<vtkVolumeFileReader> other;
    other->SetFileName(path.c_str());
    other->SetRawDimensions(this->reader->GetRawDimensions());
    other->SetRawScalarType(VTK_SHORT);
    other->SetMaximumHostMemory(TooLittleForTorso);
    std::thread reading([&] { other->Update(); });
    std::this_thread::sleep_for(std::chrono::microseconds(10 * i));
    this->reader->GetOutput()->Initialize();
    reading.join();
    EXPECT_TRUE(other->HasVoxelsOnDisk());
  }
}

std::uint64_t ResidentMemory()
{
  unsigned long long all = 0;
  unsigned long long resident = 0;
  std::FILE* const file = std::fopen("/proc/self/statm", "r");
  EXPECT_EQ(std::fscanf(file, "%llu %llu", &all, &resident), 2);
  std::fclose(file);
  return resident * std::uint64_t(sysconf(_SC_PAGESIZE));
}

// Waits for the pages to be dropped, since a busy machine may let other threads run first.
TEST_F(VoxelsOnDisk, LeaveTheMemoryThatTheyMayNotHaveUnlessTheyWereWritten)
{
  constexpr int SliceBytes = 1 << 20;
  constexpr int Slices = 320;
  const std::string path = this->folder.Write("sparse.raw", "");
  std::filesystem::resize_file(path, std::uintmax_t(SliceBytes) * Slices);
  const std::uint64_t most = ResidentMemory() + 128 * SliceBytes;
  this->reader->SetRawDimensions(1024, 1024, Slices);
  vtkImageData* const image = this->Read(path, vtkIdType(most));
  ASSERT_TRUE(this->reader->HasVoxelsOnDisk());
  auto* const voxels = static_cast<volatile char*>(image->GetScalarPointer());
  voxels[1] = 7;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  for (int i = 0; i < Slices; ++i)
  {
    for (int byte = 0; byte < SliceBytes; byte += 4096)
    {
      EXPECT_EQ(voxels[std::ptrdiff_t(i) * SliceBytes + byte], 0);
    }
    while (ResidentMemory() > most && std::chrono::steady_clock::now() < end)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_LE(ResidentMemory(), most) << "after " << i + 1 << " MiB";
  }
  EXPECT_EQ(voxels[1], 7);
  std::ifstream file(path, std::ios::binary);
  EXPECT_EQ(file.seekg(1).get(), 0) << "the file was written";
}

}
