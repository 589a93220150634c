#include "Readers/Paging/SummaryFile.h"

#include "Readers/FileError.h"
#include "Readers/VoxelLayout.h"

#include <vtkDataArray.h>
#include <vtksys/MD5.h>
#include <zlib.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

namespace varimarch
{
namespace
{

constexpr const char* Title = "varimarch ranges 3\n";

std::string DigestOf(const std::string& bytes)
{
  vtksysMD5* const md5 = vtksysMD5_New();
  vtksysMD5_Initialize(md5);
  vtksysMD5_Append(md5, reinterpret_cast<const unsigned char*>(bytes.data()), int(bytes.size()));
  char digits[33] = {};
  vtksysMD5_FinalizeHex(md5, digits);
  vtksysMD5_Delete(md5);
  return digits;
}

/// Bytes of the file at places that are spread evenly.
std::string SamplesOf(const std::string& path, std::uint64_t fileBytes)
{
  constexpr std::uint64_t Count = 64;
  constexpr std::uint64_t SampleBytes = 1024;
  std::ifstream file(path, std::ios::binary);
  std::string samples(std::size_t(Count * SampleBytes), '\0');
  for (std::uint64_t i = 0; i < Count; ++i)
  {
    file.clear();
    file.seekg(std::streamoff((fileBytes - std::min(fileBytes, SampleBytes)) / (Count - 1) * i));
    file.read(&samples[std::size_t(i * SampleBytes)], std::streamsize(SampleBytes));
  }
  return samples;
}

VoxelLayout LayoutOf(const SummarizedVoxels& voxels)
{
  return { voxels.source.Levels().front().dimensions, voxels.scalarType };
}

/// The text that tells this content from any other.
std::string KeyOf(const SummarizedVoxels& voxels)
{
  return Text(LayoutOf(voxels)) + " bricks of " + std::to_string(voxels.side) + " cells " +
    voxels.stamp + "\n";
}

/// A part of a summary that is stored.
struct Block
{
  void* bytes;
  std::size_t count;
};

/// The parts in order. The first two decide how large the others are.
std::array<Block, 6> BlocksOf(VolumeSummary& summary)
{
  return { { { &summary.smallest, sizeof(double) }, { &summary.largest, sizeof(double) },
    { &summary.areFinite, sizeof(bool) }, { summary.ranges.Memory(), summary.ranges.Bytes() },
    { summary.counts.data(), summary.counts.size() * sizeof(summary.counts[0]) },
    { summary.coarse.voxels.data(), summary.coarse.voxels.size() } } };
}

uLong CheckSumOf(VolumeSummary& summary)
{
  uLong sum = crc32_z(0, nullptr, 0);
  for (const Block& block : BlocksOf(summary))
  {
    sum = crc32_z(sum, static_cast<const Bytef*>(block.bytes), block.count);
  }
  return sum;
}

/// True for extremes that values of a type may have. Others would lead out of the counts of values.
bool ArePossible(const std::array<double, 2>& extremes, int scalarType)
{
  return extremes[0] >= vtkDataArray::GetDataTypeMin(scalarType) && extremes[0] <= extremes[1] &&
    extremes[1] <= vtkDataArray::GetDataTypeMax(scalarType);
}

/// The stored summary; null if it is of other content, or damaged.
std::shared_ptr<VolumeSummary> Restored(
  const std::string& path, const std::string& key, const SummarizedVoxels& voxels)
{
  std::ifstream file(path, std::ios::binary);
  const std::string expected = Title + key;
  std::string found(expected.size(), '\0');
  std::array<double, 2> extremes = {};
  if (!file.read(found.data(), std::streamsize(found.size())) || found != expected ||
    !file.read(reinterpret_cast<char*>(extremes.data()), sizeof(extremes)) ||
    !ArePossible(extremes, voxels.scalarType))
  {
    return nullptr;
  }
  auto summary = std::make_shared<VolumeSummary>(UnfilledSummary(voxels.source.Levels().front(),
    voxels.source.Type(), { extremes[0], extremes[1] }, voxels.side));
  const auto blocks = BlocksOf(*summary);
  for (auto block = blocks.begin() + 2; block != blocks.end(); ++block)
  {
    file.read(static_cast<char*>(block->bytes), std::streamsize(block->count));
  }
  uLong sum = 0;
  file.read(reinterpret_cast<char*>(&sum), sizeof(sum));
  return file && sum == CheckSumOf(*summary) ? summary : nullptr;
}

/// Makes an empty file that others may read only if they may read the voxels, which it is to hold
/// coarsely.
void MakeFile(const std::string& path, const std::string& voxels)
{
  struct stat status = {};
  const bool isForAll = stat(voxels.c_str(), &status) == 0 && (status.st_mode & S_IROTH) != 0;
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, isForAll ? 0644 : 0600);
  if (file >= 0)
  {
    close(file);
  }
}

/// Stores a summary under a name of its own first, so that nobody finds a part of it.
/// @param voxels  the file that it is of
bool Store(const std::string& path, const std::string& voxels, const std::string& key,
  VolumeSummary& summary)
{
  const std::string unfinished = path + "." + std::to_string(getpid());
  MakeFile(unfinished, voxels);
  {
    std::ofstream file(unfinished, std::ios::binary);
    file << Title << key;
    for (const Block& block : BlocksOf(summary))
    {
      file.write(static_cast<const char*>(block.bytes), std::streamsize(block.count));
    }
    const uLong sum = CheckSumOf(summary);
    file.write(reinterpret_cast<const char*>(&sum), sizeof(sum));
    file.close();
    if (file)
    {
      std::error_code failed;
      std::filesystem::rename(unfinished, path, failed);
      if (!failed)
      {
        return true;
      }
    }
  }
  std::error_code ignored;
  std::filesystem::remove(unfinished, ignored);
  return false;
}

/// The files that may keep the summary, best first.
std::vector<std::string> PlacesOf(const std::string& path)
{
  std::vector<std::string> places = { path + ".varimarch-ranges" };
  std::error_code ignored;
  const std::string folder = CacheFolder();
  if (!folder.empty())
  {
    places.push_back(
      folder + "/" + DigestOf(std::filesystem::absolute(path, ignored).string()) + ".ranges");
  }
  return places;
}

void CheckMemory(const SummarizedVoxels& voxels)
{
  const std::uint64_t needed =
    BytesOfBricks(voxels.source.Levels().front(), voxels.source.Type(), voxels.side);
  if (needed > voxels.mostMemoryBytes / 2)
  {
    FailToRead(voxels.path,
      "a memory of at least " + ByteText(2.0 * double(needed)) + " for the bricks of " +
        Text(LayoutOf(voxels)),
      ByteText(double(voxels.mostMemoryBytes)));
  }
}

}

bool NeedsMuchReading(const SummarizedVoxels& voxels)
{
  const auto& size = voxels.source.Levels().front().dimensions;
  const BrickSource::Box stored = voxels.source.Occupied({ { 0, 0, 0 }, size });
  double readPart = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    readPart *= double(stored.upper[axis] - stored.lower[axis]) / double(size[axis]);
  }
  return readPart > 0.1;
}

std::string StampOfFile(const std::string& path, std::uint64_t offset)
{
  const std::uint64_t fileBytes = ReadableFileSize(path);
  struct stat status = {};
  stat(path.c_str(), &status);
  return "at " + std::to_string(offset) + " of " + std::to_string(fileBytes) + " bytes, changed " +
    std::to_string(status.st_mtim.tv_sec) + "." + std::to_string(status.st_mtim.tv_nsec) +
    ", samples " + DigestOf(SamplesOf(path, fileBytes));
}

std::string CacheFolder()
{
  const char* const named = std::getenv("XDG_CACHE_HOME");
  const char* const home = std::getenv("HOME");
  const bool isNamed = named && named[0] == '/'; // the standard ignores relative paths
  return isNamed ? std::string(named) + "/varimarch"
    : home       ? std::string(home) + "/.cache/varimarch"
                 : "";
}

std::shared_ptr<const VolumeSummary> KeptSummary(const SummarizedVoxels& voxels)
{
  CheckMemory(voxels);
  const std::string key = KeyOf(voxels);
  for (const std::string& place : PlacesOf(voxels.place))
  {
    auto summary = voxels.stamp.empty() ? nullptr : Restored(place, key, voxels);
    if (summary)
    {
      return summary;
    }
  }
  return nullptr;
}

std::shared_ptr<const VolumeSummary> MadeSummary(
  const SummarizedVoxels& voxels, ReadProgress& progress)
{
  const std::string key = KeyOf(voxels);
  const std::vector<std::string> places = PlacesOf(voxels.place);
  const auto summary = std::make_shared<VolumeSummary>(SummaryOf(voxels.source,
    { voxels.mostMemoryBytes / 8, voxels.side }, [&](double part) { progress.Report(part); }));
  const bool isWorthKeeping = !voxels.stamp.empty() && NeedsMuchReading(voxels);
  if (isWorthKeeping && !Store(places.front(), voxels.path, key, *summary) && places.size() > 1)
  {
    std::error_code ignored;
    std::filesystem::create_directories(CacheFolder(), ignored);
    Store(places.back(), voxels.path, key, *summary);
  }
  return summary;
}

}
