#include "Readers/Pyramids/ZarrArray.h"

#include "Readers/FileError.h"
#include "Readers/Packed/ByteStream.h"
#include "Readers/Parsing/HeaderText.h"
#include "Readers/VoxelFile.h"

#include <vtkByteSwap.h>

#include <blosc.h>
#include <lz4.h>
#include <sys/stat.h>
#include <tbb/parallel_for.h>
#include <zlib.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <filesystem>
#include <limits>
#include <system_error>
#include <unordered_map>
#include <unordered_set>

namespace varimarch
{
namespace
{

namespace fs = std::filesystem;

/// Length of the volume's axis in a list for the axes of the array.
std::int64_t Along(
  const ArraySelection& selection, int axis, const std::vector<std::int64_t>& sizes)
{
  const std::size_t place = selection.axes[axis];
  return place == ArraySelection::NoAxis ? 1 : sizes[place];
}

/// The names in folders, each of which is listed once, since a question for each file would take
/// longer where nearly none of them is there.
class FolderNames
{
public:
  /// False if there is certainly no such file.
  bool MayHold(const fs::path& path)
  {
    const std::string folder = path.parent_path().string();
    auto known = this->folders.find(folder);
    if (known == this->folders.end())
    {
      known = this->folders.emplace(folder, NamesIn(folder)).first;
    }
    return !known->second.areKnown || known->second.names.count(path.filename().string()) > 0;
  }

private:
  struct Names
  {
    bool areKnown = false;
    std::unordered_set<std::string> names;
  };

  static Names NamesIn(const std::string& folder)
  {
    Names found;
    std::error_code problem;
    fs::directory_iterator entry(folder, problem);
    for (; !problem && entry != fs::directory_iterator(); entry.increment(problem))
    {
      found.names.insert(entry->path().filename().string());
    }
    found.areKnown = !problem || problem == std::errc::no_such_file_or_directory;
    return found;
  }

  std::unordered_map<std::string, Names> folders;
};

/// A check sum of the sizes and times of files.
class FileSum
{
public:
  /// @returns true if there is such a file
  bool Add(const std::string& path, std::uint64_t number)
  {
    struct stat status = {};
    if (stat(path.c_str(), &status) != 0)
    {
      return false;
    }
    const std::array<std::uint64_t, 4> facts = { number, std::uint64_t(status.st_size),
      std::uint64_t(status.st_mtim.tv_sec), std::uint64_t(status.st_mtim.tv_nsec) };
    this->sum = crc32_z(this->sum, reinterpret_cast<const Bytef*>(facts.data()), sizeof(facts));
    return true;
  }

  std::string Text() const { return std::to_string(this->sum); }

private:
  uLong sum = crc32_z(0, nullptr, 0);
};

void SwapToHost(bool isBigEndian, std::int64_t valueBytes, std::vector<char>& bytes)
{
  if (isBigEndian != HostIsBigEndian && valueBytes > 1)
  {
    vtkByteSwap::SwapVoidRange(
      bytes.data(), bytes.size() / std::size_t(valueBytes), std::size_t(valueBytes));
  }
}

}

ZarrArray::ZarrArray(const std::string& folder)
  : folder(folder)
  , header(ReadZarrHeader(folder))
  , valueBytes(std::int64_t(this->header.fill.size()))
{
}

std::string ZarrArray::ChunkPath(const std::vector<std::int64_t>& index) const
{
  std::string name;
  for (const std::int64_t number : index)
  {
    name += (name.empty() ? "" : this->header.separator) + std::to_string(number);
  }
  return (fs::path(this->folder) / name).string();
}

std::vector<std::int64_t> ZarrArray::ChunkSteps() const
{
  const std::size_t rank = this->header.chunk.size();
  std::vector<std::int64_t> steps(rank);
  std::int64_t step = 1;
  for (std::size_t i = 0; i < rank; ++i)
  {
    const std::size_t axis = this->header.isFortran ? i : rank - 1 - i;
    steps[axis] = step;
    step *= this->header.chunk[axis];
  }
  return steps;
}

ZarrArray::Part ZarrArray::PartIn(const std::array<std::int64_t, 3>& chunkIndex,
  const ArraySelection& selection, const BrickSource::Box& box) const
{
  const std::vector<std::int64_t> steps = this->ChunkSteps();
  std::vector<std::int64_t> index;
  Part part = {};
  for (std::size_t axis = 0; axis < selection.start.size(); ++axis)
  {
    index.push_back(selection.start[axis] / this->header.chunk[axis]);
    part.chunkOffset += selection.start[axis] % this->header.chunk[axis] * steps[axis];
  }
  const std::array<std::int64_t, 3> boxSize = SizeOf(box);
  std::int64_t boxStep = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::size_t place = selection.axes[axis];
    const std::int64_t chunkBegin = chunkIndex[axis] * Along(selection, axis, this->header.chunk);
    const std::int64_t begin = std::max(box.lower[axis], chunkBegin);
    const std::int64_t end =
      std::min(box.upper[axis], chunkBegin + Along(selection, axis, this->header.chunk));
    part.size[axis] = end - begin;
    part.boxOffset += (begin - box.lower[axis]) * boxStep;
    part.boxSteps[axis] = boxStep;
    boxStep *= boxSize[axis];
    if (place != ArraySelection::NoAxis)
    {
      index[place] = chunkIndex[axis];
      part.chunkOffset += (begin - chunkBegin) * steps[place];
    }
  }
  part.path = this->ChunkPath(index);
  return part;
}

std::vector<ZarrArray::Part> ZarrArray::PartsOf(
  const ArraySelection& selection, const BrickSource::Box& box) const
{
  std::array<std::int64_t, 3> first;
  std::array<std::int64_t, 3> last;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::int64_t length = Along(selection, axis, this->header.chunk);
    first[axis] = box.lower[axis] / length;
    last[axis] = (box.upper[axis] - 1) / length;
  }
  std::vector<Part> parts;
  for (std::int64_t k = first[2]; k <= last[2]; ++k)
  {
    for (std::int64_t j = first[1]; j <= last[1]; ++j)
    {
      for (std::int64_t i = first[0]; i <= last[0]; ++i)
      {
        parts.push_back(this->PartIn({ i, j, k }, selection, box));
      }
    }
  }
  return parts;
}

/// Copies the part of a chunk into a box, or the fill value if the chunk has no file.
bool ZarrArray::ReadPart(const Part& part, const ArraySelection& selection, char* voxels) const
{
  const std::vector<std::int64_t> all = this->ChunkSteps();
  std::array<std::int64_t, 3> steps;
  for (int axis = 0; axis < 3; ++axis)
  {
    steps[axis] = Along(selection, axis, all);
  }
  std::error_code unknown;
  const bool exists = fs::exists(part.path, unknown);
  std::vector<char> chunk;
  if (exists)
  {
    chunk.resize(CheckedChunkBytes(part.path, this->header.chunk, this->valueBytes));
    ReadZarrChunk(part.path, this->header.codec, chunk);
    SwapToHost(this->header.isBigEndian, this->valueBytes, chunk);
  }
  const auto bytes = std::size_t(this->valueBytes);
  for (std::int64_t k = 0; k < part.size[2]; ++k)
  {
    for (std::int64_t j = 0; j < part.size[1]; ++j)
    {
      char* to =
        voxels + (part.boxOffset + j * part.boxSteps[1] + k * part.boxSteps[2]) * this->valueBytes;
      const char* const row = exists
        ? chunk.data() + (part.chunkOffset + j * steps[1] + k * steps[2]) * this->valueBytes
        : this->header.fill.data();
      const std::int64_t step = exists ? steps[0] * this->valueBytes : 0;
      if (step == this->valueBytes)
      {
        std::memcpy(to, row, std::size_t(part.size[0]) * bytes);
        continue;
      }
      for (std::int64_t i = 0; i < part.size[0]; ++i, to += bytes)
      {
        std::memcpy(to, row + i * step, bytes);
      }
    }
  }
  return exists;
}

std::int64_t ZarrArray::Read(
  const ArraySelection& selection, const BrickSource::Box& box, void* voxels) const
{
  const std::vector<Part> parts = this->PartsOf(selection, box);
  std::atomic<std::int64_t> missing = 0;
  tbb::parallel_for(std::size_t(0), parts.size(),
    [&](std::size_t i)
    { missing += this->ReadPart(parts[i], selection, static_cast<char*>(voxels)) ? 0 : 1; });
  return missing;
}

StoredChunks ZarrArray::Stored(
  const ArraySelection& selection, const std::array<std::int64_t, 3>& size) const
{
  std::array<std::int64_t, 3> count;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::int64_t length = Along(selection, axis, this->header.chunk);
    count[axis] = (size[axis] - 1) / length + 1;
  }
  StoredChunks chunks;
  chunks.fill = ValueIn(this->header.fill, this->header.scalarType);
  if (double(count[0]) * double(count[1]) * double(count[2]) > MostChunksToFind)
  {
    return chunks;
  }
  FolderNames names;
  FileSum sum;
  sum.Add((fs::path(this->folder) / ZarrArrayFile).string(), 0);
  const BrickSource::Box all = { { 0, 0, 0 }, size };
  for (std::int64_t i = 0; i < count[0] * count[1] * count[2]; ++i)
  {
    const std::array<std::int64_t, 3> index = { i % count[0], i / count[0] % count[1],
      i / (count[0] * count[1]) };
    const std::string path = this->PartIn(index, selection, all).path;
    const bool isThere = names.MayHold(path) && sum.Add(path, std::uint64_t(i) + 1);
    chunks.areThere.push_back(isThere ? 1 : 0);
  }
  chunks.stamp = sum.Text();
  return chunks;
}

namespace
{

[[noreturn]] void FailToDecompress(
  const std::string& path, const std::string& codec, std::size_t expectedBytes)
{
  FailToRead(path,
    "a chunk of " + std::to_string(expectedBytes) + " bytes that " + codec + " has compressed",
    "a damaged or incomplete one");
}

void DecompressBlosc(const std::string& path, std::vector<char>& chunk)
{
  const std::string packed = WholeFile(path);
  std::size_t chunkBytes = 0;
  const bool isValid = blosc_cbuffer_validate(packed.data(), packed.size(), &chunkBytes) == 0 &&
    chunkBytes == chunk.size();
  constexpr int ThreadCount = 1; // other chunks are decompressed at the same time
  const bool isDone = isValid &&
    blosc_decompress_ctx(packed.data(), chunk.data(), chunk.size(), ThreadCount) ==
      int(chunk.size());
  if (!isDone)
  {
    FailToDecompress(path, "blosc", chunk.size());
  }
}

/// Zarr writes the number of bytes, little endian, before a block of LZ4.
void DecompressLz4(const std::string& path, std::vector<char>& chunk)
{
  const std::string packed = WholeFile(path);
  constexpr std::size_t LengthBytes = 4;
  constexpr auto Most = std::size_t(std::numeric_limits<int>::max());
  const bool fits = packed.size() > LengthBytes && packed.size() <= Most && chunk.size() <= Most;
  const bool isDone = fits &&
    LZ4_decompress_safe(packed.data() + LengthBytes, chunk.data(), int(packed.size() - LengthBytes),
      int(chunk.size())) == int(chunk.size());
  if (!isDone)
  {
    FailToDecompress(path, "lz4", chunk.size());
  }
}

void ReadStream(const std::string& path, const std::string& codec, std::vector<char>& chunk)
{
  const Compression compression = codec.empty() ? Compression::None
    : codec == "zlib" || codec == "gzip"        ? Compression::Deflate
                                                : Compression::Other;
  ReadableFileSize(path);
  const auto stream = OpenStream(path, compression);
  char behind = 0;
  if (stream->Read(chunk.data(), chunk.size()) != chunk.size() || stream->Read(&behind, 1) != 0)
  {
    FailToDecompress(path, codec.empty() ? "nothing" : codec, chunk.size());
  }
}

}

void ReadZarrChunk(const std::string& path, const std::string& codec, std::vector<char>& chunk)
{
  if (codec == "blosc")
  {
    DecompressBlosc(path, chunk);
  }
  else if (codec == "lz4")
  {
    DecompressLz4(path, chunk);
  }
  else
  {
    ReadStream(path, codec, chunk);
  }
}

}
