// OME-Zarr 0.4: https://ngff.openmicroscopy.org/0.4/
#include "Scene/VolumeWriters/ZarrFolder.h"

#include "Scene/PartFiles.h"
#include "Scene/VolumeWriters/ZarrLevels.h"

#include <nlohmann/json.hpp>
#include <vtkDataArray.h>

#include <blosc.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <stdexcept>

namespace varimarch
{

namespace
{

namespace fs = std::filesystem;

/// Writes chunks from the finest level on, each of which makes its part of the next one, so that
/// only a few chunks are in memory.
class ZarrWriting
{
public:
  ZarrWriting(const ZarrInput& input, const std::string& folder, const LoadObserver& observer)
    : input(input)
    , folder(folder)
    , observer(observer)
    , levels(ZarrLevelsOf(input.dimensions))
    , valueBytes(vtkDataArray::GetDataTypeSize(input.scalarType))
  {
    for (const std::int64_t voxels : input.dimensions)
    {
      this->fineChunks *= double(ZarrChunkCount(voxels));
    }
  }

  void Write();

private:
  ZarrBlock MakeBlock(std::size_t level, const ZarrIndex& index);
  ZarrBlock FineBlock(const ZarrIndex& lower, const ZarrIndex& size);
  void AddChildren(std::size_t level, const ZarrIndex& index, ZarrBlock& block);
  void WriteChunks(std::size_t level, const ZarrIndex& index, const ZarrBlock& block);
  std::vector<char> ChunkOf(const ZarrBlock& block, int component) const;
  std::vector<char> Packed(const std::vector<char>& chunk) const;
  void WriteFile(const fs::path& path, const char* bytes, std::size_t count) const;
  void WriteJson(const fs::path& path, const nlohmann::ordered_json& json) const;
  void Report();

  const ZarrInput& input;
  fs::path folder;
  const LoadObserver& observer;
  std::vector<ZarrLevel> levels;
  std::int64_t valueBytes;
  double fineChunks = 1.0;
  double finished = 0.0; ///< chunks of the finest level
  std::mutex mutex;      ///< held to count them and to call the observer
};

void ZarrWriting::Write()
{
  this->WriteJson(this->folder / ".zgroup", { { "zarr_format", 2 } });
  this->WriteJson(this->folder / ".zattrs", ZarrAttributes(this->input, this->levels));
  for (std::size_t level = 0; level < this->levels.size(); ++level)
  {
    const fs::path array = this->folder / std::to_string(level);
    fs::create_directories(array);
    this->WriteJson(array / ".zarray", ZarrArrayJson(this->input, this->levels[level]));
  }
  // The coarsest level is a single chunk.
  this->MakeBlock(this->levels.size() - 1, { 0, 0, 0 });
}

ZarrBlock ZarrWriting::MakeBlock(std::size_t level, const ZarrIndex& index)
{
  const ZarrIndex& dimensions = this->levels[level].dimensions;
  ZarrIndex lower;
  ZarrBlock block;
  for (int axis = 0; axis < 3; ++axis)
  {
    lower[axis] = index[axis] * ZarrChunkSide;
    block.size[axis] = std::min(ZarrChunkSide, dimensions[axis] - lower[axis]);
  }
  if (level == 0)
  {
    block = this->FineBlock(lower, block.size);
  }
  else
  {
    this->AddChildren(level, index, block);
  }
  this->WriteChunks(level, index, block);
  if (level == 0)
  {
    this->Report();
  }
  return block;
}

ZarrBlock ZarrWriting::FineBlock(const ZarrIndex& lower, const ZarrIndex& size)
{
  ZarrBlock block = { size, {} };
  block.voxels.resize(
    std::size_t(size[0] * size[1] * size[2] * this->input.componentCount * this->valueBytes));
  this->input.read(
    lower, { lower[0] + size[0], lower[1] + size[1], lower[2] + size[2] }, block.voxels.data());
  return block;
}

void ZarrWriting::AddChildren(std::size_t level, const ZarrIndex& index, ZarrBlock& block)
{
  block.voxels.resize(std::size_t(
    block.size[0] * block.size[1] * block.size[2] * this->input.componentCount * this->valueBytes));
  const ZarrIndex& factors = this->levels[level].factors;
  const ZarrIndex& fine = this->levels[level - 1].dimensions;
  std::vector<ZarrIndex> children;
  for (std::int64_t child = 0; child < 8; ++child)
  {
    const ZarrIndex offset = { child & 1, child >> 1 & 1, child >> 2 };
    bool exists = true;
    ZarrIndex place;
    for (int axis = 0; axis < 3; ++axis)
    {
      place[axis] = index[axis] * factors[axis] + offset[axis];
      exists = exists && offset[axis] < factors[axis] && place[axis] < ZarrChunkCount(fine[axis]);
    }
    if (exists)
    {
      children.push_back(place);
    }
  }
  tbb::parallel_for(std::size_t(0), children.size(),
    [&](std::size_t i)
    {
      const ZarrBlock child = this->MakeBlock(level - 1, children[i]);
      ZarrIndex place;
      for (int axis = 0; axis < 3; ++axis)
      {
        place[axis] =
          (children[i][axis] - index[axis] * factors[axis]) * ZarrChunkSide / factors[axis];
      }
      PutCoarse(this->input, child, factors, place, block);
    });
}

/// The values of a component as a whole chunk, with zeros beyond the volume.
std::vector<char> ZarrWriting::ChunkOf(const ZarrBlock& block, int component) const
{
  const auto bytes = std::size_t(this->valueBytes);
  const auto step = std::size_t(this->input.componentCount) * bytes;
  std::vector<char> chunk(std::size_t(ZarrChunkSide * ZarrChunkSide * ZarrChunkSide) * bytes, '\0');
  for (std::int64_t k = 0; k < block.size[2]; ++k)
  {
    for (std::int64_t j = 0; j < block.size[1]; ++j)
    {
      const char* from = block.voxels.data() +
        std::size_t((k * block.size[1] + j) * block.size[0]) * step +
        std::size_t(component) * bytes;
      char* to = chunk.data() + std::size_t((k * ZarrChunkSide + j) * ZarrChunkSide) * bytes;
      for (std::int64_t i = 0; i < block.size[0]; ++i, from += step, to += bytes)
      {
        std::memcpy(to, from, bytes);
      }
    }
  }
  return chunk;
}

std::vector<char> ZarrWriting::Packed(const std::vector<char>& chunk) const
{
  constexpr int Strength = 5;
  constexpr int ThreadCount = 1; // other chunks are compressed at the same time
  std::vector<char> packed(chunk.size() + BLOSC_MAX_OVERHEAD);
  const int count = blosc_compress_ctx(Strength, BLOSC_SHUFFLE, std::size_t(this->valueBytes),
    chunk.size(), chunk.data(), packed.data(), packed.size(), "zstd", 0, ThreadCount);
  if (count <= 0)
  {
    throw std::runtime_error("The library blosc could not compress a chunk by zstd.");
  }
  packed.resize(std::size_t(count));
  return packed;
}

void ZarrWriting::WriteChunks(std::size_t level, const ZarrIndex& index, const ZarrBlock& block)
{
  const bool hasComponents = this->input.componentCount > 1;
  for (int component = 0; component < this->input.componentCount; ++component)
  {
    fs::path path = this->folder / std::to_string(level);
    path = hasComponents ? path / std::to_string(component) : path;
    path = path / std::to_string(index[2]) / std::to_string(index[1]);
    fs::create_directories(path);
    const std::vector<char> packed = this->Packed(this->ChunkOf(block, component));
    this->WriteFile(path / std::to_string(index[0]), packed.data(), packed.size());
  }
}

void ZarrWriting::WriteFile(const fs::path& path, const char* bytes, std::size_t count) const
{
  errno = 0;
  std::ofstream stream(path, std::ios::binary);
  stream.write(bytes, std::streamsize(count));
  stream.close();
  if (!stream)
  {
    FailToWrite(path.string());
  }
}

void ZarrWriting::WriteJson(const fs::path& path, const nlohmann::ordered_json& json) const
{
  const std::string text = json.dump(2) + "\n";
  this->WriteFile(path, text.data(), text.size());
}

void ZarrWriting::Report()
{
  const std::lock_guard<std::mutex> lock(this->mutex);
  this->finished += 1.0;
  if (this->observer && !this->observer(this->finished / this->fineChunks))
  {
    throw std::runtime_error("Writing was stopped");
  }
}

}

void WriteZarr(const ZarrInput& input, const std::string& folder, const LoadObserver& observer)
{
  const ZarrInput inOrder = InLpsOrder(input);
  ZarrWriting(inOrder, folder, observer).Write();
}

std::string LossOfZarr(const ZarrInput& input)
{
  const glm::dmat3 direction = InLpsOrder(input).direction;
  constexpr double Rounding = 1e-9;
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int row = 0; row < 3; ++row)
    {
      largest = std::max(largest, std::abs(direction[axis][row] - (axis == row ? 1.0 : 0.0)));
    }
  }
  return largest > Rounding
    ? "OME-Zarr 0.4 holds no oblique directions of axes, so the folder has only the nearest sides "
      "of "
      "the patient, the spacing of the voxels and the position of the first one."
    : "";
}

}
