#include "Readers/Pyramids/ZarrArray.h"

#include "Readers/FileError.h"
#include "Readers/Pyramids/VoxelPyramid.h"
#include "Readers/VoxelFile.h"

#include <vtkByteSwap.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <filesystem>

namespace varimarch
{
namespace
{

namespace fs = std::filesystem;

/// Length of the volume's axis in a list for the axes of the array.
std::int64_t Along(const ZarrSelection& selection, int axis, const std::vector<std::int64_t>& sizes)
{
  const std::size_t place = selection.axes[axis];
  return place == ZarrSelection::NoAxis ? 1 : sizes[place];
}

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
  const ZarrSelection& selection, const BrickSource::Box& box) const
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
    if (place != ZarrSelection::NoAxis)
    {
      index[place] = chunkIndex[axis];
      part.chunkOffset += (begin - chunkBegin) * steps[place];
    }
  }
  part.path = this->ChunkPath(index);
  return part;
}

std::vector<ZarrArray::Part> ZarrArray::PartsOf(
  const ZarrSelection& selection, const BrickSource::Box& box) const
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
bool ZarrArray::ReadPart(const Part& part, const ZarrSelection& selection, char* voxels) const
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
  const ZarrSelection& selection, const BrickSource::Box& box, void* voxels) const
{
  const std::vector<Part> parts = this->PartsOf(selection, box);
  std::atomic<std::int64_t> missing = 0;
  tbb::parallel_for(std::size_t(0), parts.size(),
    [&](std::size_t i)
    { missing += this->ReadPart(parts[i], selection, static_cast<char*>(voxels)) ? 0 : 1; });
  return missing;
}

}
