// OME-Zarr 0.4: https://ngff.openmicroscopy.org/0.4/

#include "Scene/Volumes/VolumeWriters/ZarrFolder.h"

#include "Readers/Decoder/DecodedPyramid.h"
#include "Readers/ImageFacts.h"
#include "Scene/Files/OutputFile.h"
#include "Scene/Volumes/VolumeWriters/WrittenImage.h"

#include <vtkDataArray.h>
#include <vtkSetGet.h>

#include <blosc.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <utility>
#include <vector>

namespace varimarch
{

namespace
{

using ZarrIndex = std::array<std::int64_t, 3>;

/// Voxels of a written chunk along each axis.
constexpr std::int64_t ZarrChunkSide = 64;

/// A level of a written pyramid.
struct ZarrLevel
{
  ZarrIndex dimensions;
  ZarrIndex factors; ///< voxels of the level before per voxel along each axis, 1 or 2
};

/// The voxels of a chunk that lie in its level, densely.
struct ZarrBlock
{
  ZarrIndex size;
  std::vector<char> voxels;
};

/// A fine block, and the groups of its voxels.
template <class Number>
struct FineVoxels
{
  const Number* values;
  ZarrIndex size;
  ZarrIndex factors;
  int componentCount;

  const Number& At(const ZarrIndex& at, int component) const
  {
    const std::int64_t voxel = (at[2] * this->size[1] + at[1]) * this->size[0] + at[0];
    return this->values[voxel * this->componentCount + component];
  }

  /// The mean of a group, rounded for whole numbers. Groups at the end may be cut.
  Number MeanAt(const ZarrIndex& first, int component) const
  {
    double sum = 0.0;
    double count = 0.0;
    for (std::int64_t k = first[2]; k < std::min(this->size[2], first[2] + this->factors[2]); ++k)
    {
      for (std::int64_t j = first[1]; j < std::min(this->size[1], first[1] + this->factors[1]); ++j)
      {
        for (std::int64_t i = first[0]; i < std::min(this->size[0], first[0] + this->factors[0]);
             ++i, ++count)
        {
          sum += double(this->At({ i, j, k }, component));
        }
      }
    }
    const double mean = sum / count;
    return Number(std::numeric_limits<Number>::is_integer ? std::floor(mean + 0.5) : mean);
  }
};

template <class Number>
void PutNumbers(
  const FineVoxels<Number>& fine, const ZarrIndex& place, bool isLabels, ZarrBlock& block)
{
  auto* const coarse = reinterpret_cast<Number*>(block.voxels.data());
  ZarrIndex size;
  for (int axis = 0; axis < 3; ++axis)
  {
    size[axis] = (fine.size[axis] + fine.factors[axis] - 1) / fine.factors[axis];
  }
  for (std::int64_t k = 0; k < size[2]; ++k)
  {
    for (std::int64_t j = 0; j < size[1]; ++j)
    {
      const std::int64_t row =
        ((place[2] + k) * block.size[1] + place[1] + j) * block.size[0] + place[0];
      for (std::int64_t i = 0; i < size[0]; ++i)
      {
        const ZarrIndex first = { i * fine.factors[0], j * fine.factors[1], k * fine.factors[2] };
        for (int component = 0; component < fine.componentCount; ++component)
        {
          coarse[(row + i) * fine.componentCount + component] =
            isLabels ? fine.At(first, component) : fine.MeanAt(first, component);
        }
      }
    }
  }
}

/// The levels from fine to coarse. The last is a single chunk.
std::vector<ZarrLevel> ZarrLevelsOf(const ZarrIndex& dimensions)
{
  std::vector<ZarrLevel> levels = { { dimensions, { 1, 1, 1 } } };
  while (*std::max_element(levels.back().dimensions.begin(), levels.back().dimensions.end()) >
    ZarrChunkSide)
  {
    ZarrLevel next = { levels.back().dimensions, { 1, 1, 1 } };
    for (int axis = 0; axis < 3; ++axis)
    {
      next.factors[axis] = next.dimensions[axis] > ZarrChunkSide ? 2 : 1;
      next.dimensions[axis] = (next.dimensions[axis] + next.factors[axis] - 1) / next.factors[axis];
    }
    levels.push_back(next);
  }
  return levels;
}

/// Chunks along an axis.
std::int64_t ZarrChunkCount(std::int64_t voxels)
{
  return (voxels + ZarrChunkSide - 1) / ZarrChunkSide;
}

/// Puts the mean of each group of a child's voxels at its place in a coarser block; for labels the
/// first voxel of the group.
/// @param place  first voxel in the coarser block
void PutCoarse(const ZarrInput& input, const ZarrBlock& child, const ZarrIndex& factors,
  const ZarrIndex& place, ZarrBlock& block)
{
  switch (input.scalarType)
  {
    vtkTemplateMacro(PutNumbers<VTK_TT>({ reinterpret_cast<const VTK_TT*>(child.voxels.data()),
                                          child.size, factors, input.componentCount },
      place, input.isLabels, block));
  }
}

/// A type in NumPy's words, such as "<u2".
std::string NumPyType(int scalarType)
{
  const int valueBytes = vtkDataArray::GetDataTypeSize(scalarType);
  const bool isReal = scalarType == VTK_FLOAT || scalarType == VTK_DOUBLE;
  const bool isSigned = vtkDataArray::GetDataTypeMin(scalarType) < 0.0;
  const std::string order = valueBytes == 1 ? "|" : IsBigEndianMachine() ? ">" : "<";
  return order + (isReal ? "f" : isSigned ? "i" : "u") + std::to_string(valueBytes);
}

/// The transforms of a level. A coarse voxel lies in the middle of the fine ones that it covers.
nlohmann::ordered_json DatasetJson(
  const ZarrInput& input, const std::vector<ZarrLevel>& levels, std::size_t level)
{
  glm::dvec3 factor(1.0);
  for (std::size_t i = 0; i <= level; ++i)
  {
    const ZarrIndex& factors = levels[i].factors;
    factor *= glm::dvec3(double(factors[0]), double(factors[1]), double(factors[2]));
  }
  const glm::dvec3 scale = input.spacingMm * factor;
  const glm::dvec3 shift = input.isLabels ? glm::dvec3(0.0) : 0.5 * (factor - 1.0);
  const glm::dvec3 place = input.originMm + input.spacingMm * shift;
  nlohmann::ordered_json scales = { scale.z, scale.y, scale.x };
  nlohmann::ordered_json places = { place.z, place.y, place.x };
  if (input.componentCount > 1)
  {
    scales.insert(scales.begin(), 1.0);
    places.insert(places.begin(), 0.0);
  }
  return { { "path", std::to_string(level) },
    { "coordinateTransformations",
      { { { "type", "scale" }, { "scale", scales } },
        { { "type", "translation" }, { "translation", places } } } } };
}

/// The range of values to show, for each component.
nlohmann::ordered_json ChannelsJson(const ZarrInput& input)
{
  const auto [width, middle] = *input.windowLevel;
  const double from = middle - 0.5 * width;
  const double to = middle + 0.5 * width;
  const nlohmann::ordered_json window = { { "min", from }, { "max", to }, { "start", from },
    { "end", to } };
  nlohmann::ordered_json channels = nlohmann::ordered_json::array();
  for (int component = 0; component < input.componentCount; ++component)
  {
    channels.push_back({ { "active", component == 0 }, { "color", "FFFFFF" },
      { "label", std::to_string(component) }, { "window", window } });
  }
  return channels;
}

/// The description of an array.
nlohmann::ordered_json ZarrArrayJson(const ZarrInput& input, const ZarrLevel& level)
{
  const ZarrIndex& size = level.dimensions;
  nlohmann::ordered_json shape = { size[2], size[1], size[0] };
  nlohmann::ordered_json chunks = { ZarrChunkSide, ZarrChunkSide, ZarrChunkSide };
  if (input.componentCount > 1)
  {
    shape.insert(shape.begin(), input.componentCount);
    chunks.insert(chunks.begin(), 1);
  }
  return { { "zarr_format", 2 }, { "shape", shape }, { "chunks", chunks },
    { "dtype", NumPyType(input.scalarType) },
    { "compressor",
      { { "id", "blosc" }, { "cname", "zstd" }, { "clevel", 5 }, { "shuffle", 1 },
        { "blocksize", 0 } } },
    { "fill_value", 0 }, { "order", "C" }, { "filters", nullptr }, { "dimension_separator", "/" } };
}

/// The metadata of OME-Zarr 0.4.
nlohmann::ordered_json ZarrAttributes(const ZarrInput& input, const std::vector<ZarrLevel>& levels)
{
  nlohmann::ordered_json axes = nlohmann::ordered_json::array();
  if (input.componentCount > 1)
  {
    axes.push_back({ { "name", "c" }, { "type", "channel" } });
  }
  const std::pair<const char*, const char*> spatial[] = { { "z", "inferior-to-superior" },
    { "y", "anterior-to-posterior" }, { "x", "right-to-left" } };
  for (const auto& [name, direction] : spatial)
  {
    nlohmann::ordered_json axis = { { "name", name }, { "type", "space" },
      { "unit", "millimeter" } };
    if (input.statesSides)
    {
      axis["orientation"] = { { "type", "anatomical" }, { "value", direction } };
    }
    axes.push_back(axis);
  }
  nlohmann::ordered_json datasets = nlohmann::ordered_json::array();
  for (std::size_t level = 0; level < levels.size(); ++level)
  {
    datasets.push_back(DatasetJson(input, levels, level));
  }
  nlohmann::ordered_json multiscale = { { "version", "0.4" }, { "axes", axes },
    { "datasets", datasets }, { "type", input.isLabels ? "nearest" : "mean" } };
  nlohmann::ordered_json attributes;
  attributes["multiscales"] = nlohmann::ordered_json::array({ multiscale });
  if (input.windowLevel)
  {
    attributes["omero"] = { { "channels", ChannelsJson(input) } };
  }
  return attributes;
}

}

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

// The volumes that WriteZarr writes: in memory, or in a file with chunks.

namespace
{

// The levels of a file; null for files without levels.
std::shared_ptr<DecodedPyramid> PyramidOf(const FileSource& source)
{
  if (source.timeSeconds)
  {
    return nullptr; // a reader finds the time that is nearest
  }
  ReadProgress silent([](double) { return true; });
  ReadOptions options;
  options.channel = source.channel.value_or(0);
  options.time = source.time;
  return OpenPyramidAt(source.path, options, silent);
}

bool StatesSides(const std::vector<std::string>& warnings)
{
  return std::find(warnings.begin(), warnings.end(), UnknownSides) == warnings.end();
}

}

ZarrInput ZarrInputOf(const LoadedVolume& volume)
{
  const WrittenImage image("OME-Zarr", volume.image);
  const std::array<int, 3> size = image.Size();
  ZarrInput input = { { size[0], size[1], size[2] }, volume.image->GetScalarType(),
    image.ComponentCount(), image.OriginMm(), image.SpacingMm(), image.Direction() };
  input.windowLevel = volume.windowLevel;
  input.isLabels = !volume.segments.empty();
  input.statesSides = ShowsPatient(volume.image) && StatesSides(volume.warnings);
  const char* const values = image.Values();
  const auto voxelBytes = std::int64_t(image.ValueBytes()) * image.ComponentCount();
  input.read = [=](const auto& lower, const auto& upper, void* voxels)
  {
    char* to = static_cast<char*>(voxels);
    const auto rowBytes = std::size_t((upper[0] - lower[0]) * voxelBytes);
    for (std::int64_t k = lower[2]; k < upper[2]; ++k)
    {
      for (std::int64_t j = lower[1]; j < upper[1]; ++j, to += rowBytes)
      {
        const std::int64_t first = (k * size[1] + j) * size[0] + lower[0];
        std::memcpy(to, values + first * voxelBytes, rowBytes);
      }
    }
  };
  return input;
}

std::optional<ZarrInput> ChunkedInput(const FileSource& source, std::vector<std::string>& warnings)
{
  const std::shared_ptr<DecodedPyramid> pyramid = PyramidOf(source);
  if (!pyramid)
  {
    return std::nullopt;
  }
  const PyramidForm& form = pyramid->Form();
  const auto level = std::size_t(source.level.value_or(0));
  if (level >= form.levels.size())
  {
    throw std::runtime_error(source.path + ": expected a level from 0 to " +
      std::to_string(form.levels.size() - 1) + ", found " + std::to_string(level));
  }
  warnings.insert(warnings.end(), form.warnings.begin(), form.warnings.end());
  if (!form.otherChannels.empty())
  {
    warnings.push_back(form.otherChannels);
  }
  const ImageGeometry& geometry = form.geometries[level];
  ZarrInput input = { form.levels[level].dimensions, form.scalarType, 1, geometry.originMm };
  for (int axis = 0; axis < 3; ++axis)
  {
    input.spacingMm[axis] = glm::length(geometry.axesMm[axis]);
    input.direction[axis] = geometry.axesMm[axis] / input.spacingMm[axis];
  }
  if (form.windowLevel)
  {
    input.windowLevel = { form.windowLevel->window, form.windowLevel->level };
  }
  input.statesSides = StatesSides(form.warnings);
  const auto lacksChunks = std::make_shared<std::atomic<bool>>(false);
  input.lacksChunks = lacksChunks;
  input.read = [pyramid, level, lacksChunks](const auto& lower, const auto& upper, void* voxels)
  {
    ReadProgress noProgress([](double) { return true; });
    if (pyramid->ReadStored(int(level), { lower, upper }, voxels, noProgress) > 0)
    {
      *lacksChunks = true;
    }
  };
  return input;
}

}
