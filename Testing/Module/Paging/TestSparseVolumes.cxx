// Volumes of which the store has only parts: the rest is not read, and counts as if it were stored.
#include "Module/Files/PhantomLibraryFiles.h"
#include "Module/Paging/VoxelsInChunks.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkStringArray.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace
{

/// The facts that a reader keeps beside a volume, without the lines that name the volume.
std::string KeptFacts(const std::string& path)
{
  std::ifstream file(path + ".varimarch-ranges", std::ios::binary);
  std::string line;
  std::getline(file, line);
  std::getline(file, line);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

/// Half of the torso, in a pattern of chunks.
class SparseVolumes : public VoxelsInChunks
{
protected:
  static bool IsStored(const std::array<int, 3>& chunk)
  {
    return (chunk[0] + chunk[1] / 2 + chunk[2] / 3) % 2 == 0;
  }

  static int CountOfMissing(const Shape& shape)
  {
    int count = 0;
    EachChunk(shape, [&](const std::array<int, 3>& chunk) { count += IsStored(chunk) ? 0 : 1; });
    return count;
  }

  template <class Take>
  static void EachChunk(const Shape& shape, Take take)
  {
    for (int k = 0; k * shape.chunk[2] < shape.size[2]; ++k)
    {
      for (int j = 0; j * shape.chunk[1] < shape.size[1]; ++j)
      {
        for (int i = 0; i * shape.chunk[0] < shape.size[0]; ++i)
        {
          take({ i, j, k });
        }
      }
    }
  }

  /// The torso with the fill value where chunks are missing.
  static vtkSmartPointer<vtkImageData> Filled(const Shape& shape, int fill)
  {
    const vtkSmartPointer<vtkImageData> torso = Torso(shape);
    auto* const voxels = static_cast<short*>(torso->GetScalarPointer());
    for (int i = 0; i < int(torso->GetNumberOfPoints()); ++i)
    {
      const std::array<int, 3> at = { i % shape.size[0], i / shape.size[0] % shape.size[1],
        i / (shape.size[0] * shape.size[1]) };
      const bool isStored =
        IsStored({ at[0] / shape.chunk[0], at[1] / shape.chunk[1], at[2] / shape.chunk[2] });
      voxels[i] = isStored ? voxels[i] : short(fill);
    }
    return torso;
  }

  /// The facts that are kept about a volume of which all voxels are read.
  std::string FactsWithAllChunks(vtkImageData* filled, const Shape& shape)
  {
    this->Read(this->WriteZarr(filled, shape));
    EXPECT_TRUE(this->reader->HasVoxelsOnDisk());
    return KeptFacts(this->folder.Path("a.zarr.0.0.0"));
  }

  /// Expects that a volume has the voxels, and those facts.
  void ExpectAlike(const std::string& path, vtkImageData* filled, const std::string& facts)
  {
    vtkImageData* const image = this->Read(path);
    EXPECT_TRUE(this->reader->HasVoxelsOnDisk());
    EXPECT_TRUE(
      std::equal(Voxels(filled), Voxels(filled) + filled->GetNumberOfPoints(), Voxels(image)));
    EXPECT_FALSE(facts.empty());
    EXPECT_TRUE(KeptFacts(path + ".0.0.0") == facts);
  }

  void ExpectWarning(const std::string& text)
  {
    vtkStringArray* const warnings = this->reader->GetWarnings();
    bool isFound = false;
    for (vtkIdType i = 0; i < warnings->GetNumberOfValues(); ++i)
    {
      isFound = isFound || warnings->GetValue(i).find(text) == 0;
    }
    EXPECT_TRUE(isFound) << text;
  }
};

TEST_F(SparseVolumes, OfZarrHaveTheRangesOfThoseWithAllChunks)
{
  for (const int fill : { 0, -1024 })
  {
    const vtkSmartPointer<vtkImageData> filled = Filled(uneven, fill);
    const std::string facts = this->FactsWithAllChunks(filled, uneven);
    this->WriteZarr(filled, uneven, fill);
    EachChunk(uneven,
      [&](const std::array<int, 3>& chunk)
      {
        if (!IsStored(chunk))
        {
          std::filesystem::remove(this->folder.Path(this->ChunkOf(chunk)));
        }
      });
    this->ExpectAlike(this->folder.Path("a.zarr"), filled, facts);
    this->ExpectWarning(std::to_string(CountOfMissing(uneven)) + " chunks are not stored");
  }
}

TEST_F(SparseVolumes, OfHdf5HaveTheRangesOfThoseWithAllChunks)
{
  for (const int fill : { 0, -1024 })
  {
    const vtkSmartPointer<vtkImageData> filled = Filled(uneven, fill);
    const std::string facts = this->FactsWithAllChunks(filled, uneven);
    const std::string path = this->folder.Path("a.h5");
    const std::vector<short> voxels(Voxels(filled), Voxels(filled) + filled->GetNumberOfPoints());
    WriteSparseHdf5(path, { uneven.size, uneven.chunk, fill, voxels, IsStored });
    this->ExpectAlike(path, filled, facts);
    this->ExpectWarning(std::to_string(CountOfMissing(uneven)) + " chunks are not stored");
  }
}

/// Bytes that this process has read; 0 if the system does not tell.
std::uint64_t BytesRead()
{
  std::ifstream file("/proc/self/io");
  std::string name;
  std::uint64_t bytes = 0;
  file >> name >> bytes;
  return bytes;
}

TEST_F(SparseVolumes, InRawFilesAreReadOnlyWhereTheFileHasVoxels)
{
  constexpr int Side = 1024;
  constexpr int Middle = 700;
  constexpr std::uintmax_t FileBytes = std::uintmax_t(Side) * Side * Side;
  const std::string path = this->folder.Write("sparse.raw", "");
  std::filesystem::resize_file(path, FileBytes);
  {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(std::streamoff(Middle) * Side * Side + Side + 1);
    file.put(7);
  }
  this->reader->SetRawDimensions(Side, Side, Side);
  const std::uint64_t before = BytesRead();
  constexpr vtkIdType Memory = 400000000;
  vtkImageData* const image = this->Read(path, Memory);
  EXPECT_LT(BytesRead() - before, FileBytes / 10);
  ASSERT_TRUE(this->reader->HasVoxelsOnDisk());
  EXPECT_EQ(image->GetScalarComponentAsDouble(1, 1, Middle, 0), 7.0);
  const std::string facts = KeptFacts(path);
  std::array<double, 2> extremes = {};
  ASSERT_GT(facts.size(), sizeof(extremes));
  std::memcpy(extremes.data(), facts.data(), sizeof(extremes));
  EXPECT_EQ(extremes, (std::array<double, 2>{ 0.0, 7.0 }));
}

// Chunks that nobody can decode show which level is opened.
TEST_F(SparseVolumes, AreNotReadForHoursUnlessTheirFinestLevelIsAskedFor)
{
  constexpr int Chunks = 20; // along each axis: 8,000 of 16 MiB, beyond 100 GB
  const auto describe = [&](const char* level, int voxels, int chunk)
  {
    const std::string size = std::to_string(voxels);
    const std::string ofChunk = std::to_string(chunk);
    this->folder.Write(std::string("p.zarr/") + level + "/.zarray",
      R"({"zarr_format": 2, "shape": [)" + size + ", " + size + ", " + size + R"(], "chunks": [)" +
        ofChunk + ", " + ofChunk + ", " + ofChunk +
        R"(], "dtype": "|u1", "compressor": null, "order": "C", "filters": null, "fill_value": 0})");
  };
  describe("0", Chunks * 256, 256);
  describe("1", 64, 64);
  this->folder.Write("p.zarr/1/0.0.0", std::string(64 * 64 * 64, '\5'));
  this->folder.Write("p.zarr/.zattrs", R"({"multiscales": [{"version": "0.4", "axes": [
    {"name": "z", "type": "space"}, {"name": "y", "type": "space"}, {"name": "x", "type": "space"}],
    "datasets": [{"path": "0", "coordinateTransformations": [{"type": "scale", "scale": [1, 1, 1]}]},
    {"path": "1", "coordinateTransformations": [{"type": "scale", "scale": [80, 80, 80]}]}]}]})");
  constexpr vtkIdType Memory = 4000000000;
  vtkImageData* const sparse = this->Read(this->folder.Path("p.zarr"), Memory);
  EXPECT_EQ(sparse->GetDimensions()[0], Chunks * 256) << "of a store with few chunks";
  for (int i = 0; i < Chunks * Chunks * Chunks; ++i)
  {
    this->folder.Write("p.zarr/0/" + std::to_string(i % Chunks) + "." +
        std::to_string(i / Chunks % Chunks) + "." + std::to_string(i / (Chunks * Chunks)),
      "damaged");
  }
  vtkImageData* const chosen = this->Read(this->folder.Path("p.zarr"), Memory);
  EXPECT_EQ(chosen->GetDimensions()[0], 64);
  this->ExpectWarning("Level 1, 64 x 64 x 64 voxels of unsigned char, was read: the voxels of the "
                      "finest, 5120 x 5120 x 5120 voxels of unsigned char, have to be read once "
                      "before they are drawn, 134.2 GB in 0.4 hours at 100 MB a second; ask for "
                      "level 0 to have them.");
  this->reader->SetResolutionLevel(0);
  const ExpectedVtkErrors errors;
  this->Read(this->folder.Path("p.zarr"), Memory);
  EXPECT_NE(errors.Text().find("a chunk of 16777216 bytes"), std::string::npos) << errors.Text();
}

}
