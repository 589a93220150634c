#include "Readers/ChunkedVoxels.h"

#include "Readers/FileError.h"
#include "Readers/PageMap.h"
#include "Readers/VoxelLayout.h"

#include <sys/mman.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <exception>
#include <utility>

namespace varimarch
{
namespace
{

std::size_t BytesOfVoxel(VoxelType type)
{
  return ByVoxelType(type, [](auto voxel) { return sizeof(voxel); });
}

std::uint64_t TimeNow()
{
  return std::uint64_t(std::chrono::steady_clock::now().time_since_epoch().count());
}

bool IsEmpty(const BrickSource::Box& box)
{
  return box.lower[0] >= box.upper[0];
}

/// The size of units that do not need a decoder each few rows, of which the memory has many.
double WantedUnitBytes(std::uint64_t mostMemoryBytes)
{
  return std::min(16e6, double(mostMemoryBytes) / 256.0);
}

/// The bytes of a slice of a box that is in memory; 0 without voxels.
std::size_t BytesOfSlice(const std::vector<char>& voxels, const BrickSource::Box& box)
{
  return voxels.size() / std::size_t(box.upper[2] - box.lower[2]);
}

}

std::string ChunkedVoxels::Obstacle(
  const BrickSource::Level& level, std::size_t voxelBytes, std::uint64_t mostMemoryBytes)
{
  if (!PageFaults::Obstacle().empty())
  {
    return "cannot be read when they are needed, since " + PageFaults::Obstacle();
  }
  if (!VoxelUnits::AreIn(level, voxelBytes, PageBytes()))
  {
    return "are in slices of less than two pages of memory";
  }
  const double unitBytes = double(
    VoxelUnits(level, voxelBytes, PageBytes(), WantedUnitBytes(mostMemoryBytes)).MostBytes());
  constexpr double MostPart = 1.0 / 8.0;
  return unitBytes > MostPart * double(mostMemoryBytes)
    ? "are in chunks of which a row needs " + ByteText(unitBytes)
    : "";
}

ChunkedVoxels::ChunkedVoxels(std::unique_ptr<const BrickSource> newSource, const std::string& path,
  std::uint64_t mostMemoryBytes)
  : source(std::move(newSource))
  , voxelBytes(BytesOfVoxel(this->source->Type()))
  , units(this->source->Levels().front(), this->voxelBytes, PageBytes(),
      WantedUnitBytes(mostMemoryBytes))
  , states(this->units.Count())
{
  const auto& size = this->source->Levels().front().dimensions;
  const std::uint64_t page = PageBytes();
  this->pageBytes =
    (this->units.RowBytes() * std::uint64_t(size[1] * size[2]) + page - 1) / page * page;
  void* const addresses = mmap(nullptr, this->pageBytes, PROT_READ | PROT_WRITE,
    MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (addresses == MAP_FAILED)
  {
    FailToRead(path, "addresses for " + ByteText(double(this->pageBytes)) + " of voxels",
      std::strerror(errno));
  }
  this->pages = static_cast<char*>(addresses);
  // A process that is forked would find zeros there instead of voxels.
  madvise(addresses, this->pageBytes, MADV_DONTFORK);
  madvise(addresses, this->pageBytes, MADV_NOHUGEPAGE);
  try
  {
    this->faults.emplace(this->pages, this->pageBytes);
    this->server = std::thread([this] { this->Serve(); });
  }
  catch (const std::exception& error)
  {
    munmap(this->pages, this->pageBytes);
    FailToRead(path, "voxels that are read when they are needed", error.what());
  }
}

ChunkedVoxels::~ChunkedVoxels()
{
  this->faults->Stop();
  this->server.join();
  this->faults.reset();
  munmap(this->pages, this->pageBytes);
}

std::string ChunkedVoxels::Problem() const
{
  const std::lock_guard<std::mutex> lock(this->mutex);
  return this->problem;
}

std::vector<PagedVoxels::Part> ChunkedVoxels::DroppableParts(const PageMap&, std::uint64_t)
{
  const std::lock_guard<std::mutex> lock(this->mutex);
  std::vector<Part> parts;
  for (std::size_t i = 0; i < this->states.size(); ++i)
  {
    if (this->states[i].state == State::Read)
    {
      parts.push_back({ i, this->BytesOf(i), this->states[i].readAt });
    }
  }
  return parts;
}

std::size_t ChunkedVoxels::Drop(std::size_t index, const PageMap&)
{
  const std::lock_guard<std::mutex> lock(this->mutex);
  if (this->states[index].state != State::Read)
  {
    return 0;
  }
  const BrickSource::Box box = this->units.BoxOf(index);
  for (std::int64_t slice = box.lower[2]; slice < box.upper[2]; ++slice)
  {
    const VoxelUnits::Run run = this->units.RunOf(index, slice);
    madvise(this->pages + run.begin, run.end - run.begin, MADV_DONTNEED);
  }
  this->states[index].state = State::Missing;
  return this->BytesOf(index);
}

std::size_t ChunkedVoxels::BytesOf(std::size_t unit) const
{
  const BrickSource::Box box = this->units.BoxOf(unit);
  const VoxelUnits::Run run = this->units.RunOf(unit, box.lower[2]);
  return std::size_t(run.end - run.begin) * std::size_t(box.upper[2] - box.lower[2]);
}

void ChunkedVoxels::Serve()
{
  while (const std::optional<PageFaults::Fault> fault = this->faults->Next())
  {
    const std::size_t unit = this->units.UnitAt(std::uint64_t(fault->page - this->pages));
    if (fault->isFirstWrite)
    {
      const std::lock_guard<std::mutex> lock(this->mutex);
      State& state = this->states[unit].state;
      state = state == State::Read ? State::Kept : state;
      this->faults->AllowWriting(fault->page);
      continue;
    }
    this->Provide(unit);
    this->faults->Wake(fault->page);
  }
}

// No other thread provides a unit, so that the lock is not held while it is read and put there.
// MappedMemory needs the lock to drop others, for which pages have to wait where memory is short.
void ChunkedVoxels::Provide(std::size_t unit)
{
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    if (this->states[unit].state != State::Missing)
    {
      return;
    }
  }
  try
  {
    const bool isOfZeros = this->IsOfZeros(unit);
    isOfZeros ? this->PutZeros(unit) : this->PutVoxels(unit);
    const std::lock_guard<std::mutex> lock(this->mutex);
    this->states[unit] = { isOfZeros ? State::Kept : State::Read, TimeNow() };
  }
  catch (const std::exception& error)
  {
    this->PutZeros(unit);
    const std::lock_guard<std::mutex> lock(this->mutex);
    this->states[unit].state = State::Kept;
    this->problem = error.what();
    this->problem.resize(this->problem.find_last_not_of('.') + 1);
    this->problem += "; voxels that are missing count as 0. Open the volume again when it is whole";
  }
}

bool ChunkedVoxels::IsOfZeros(std::size_t unit) const
{
  const std::optional<BrickSource::Box> behind = this->units.BoxBehind(unit);
  return this->source->Fill() == 0.0 && IsEmpty(this->source->Occupied(this->units.BoxOf(unit))) &&
    (!behind || IsEmpty(this->source->Occupied(*behind)));
}

std::vector<char> ChunkedVoxels::VoxelsOf(const BrickSource::Box& box) const
{
  const auto rows = std::size_t((box.upper[1] - box.lower[1]) * (box.upper[2] - box.lower[2]));
  std::vector<char> voxels(rows * this->units.RowBytes());
  this->source->Read(0, box, voxels.data());
  return voxels;
}

void ChunkedVoxels::PutVoxels(std::size_t unit)
{
  const BrickSource::Box box = this->units.BoxOf(unit);
  const std::vector<char> own = this->VoxelsOf(box);
  const std::optional<BrickSource::Box> boxBehind = this->units.BoxBehind(unit);
  const std::vector<char> behind = boxBehind ? this->VoxelsOf(*boxBehind) : std::vector<char>();
  const std::size_t ownSlice = BytesOfSlice(own, box);
  const std::size_t sliceBehind = boxBehind ? BytesOfSlice(behind, *boxBehind) : 0;
  std::vector<char> bytes;
  for (std::int64_t slice = box.lower[2]; slice < box.upper[2]; ++slice)
  {
    const auto number = std::size_t(slice - box.lower[2]);
    const VoxelUnits::Run run = this->units.RunOf(unit, slice);
    const std::size_t skipped = run.begin - this->units.ByteOfRow(box.lower[1], slice);
    bytes.assign(own.begin() + std::ptrdiff_t(number * ownSlice + skipped),
      own.begin() + std::ptrdiff_t((number + 1) * ownSlice));
    const auto next =
      behind.begin() + std::ptrdiff_t(std::min(number * sliceBehind, behind.size()));
    bytes.insert(bytes.end(), next,
      next + std::ptrdiff_t(std::min(sliceBehind, std::size_t(behind.end() - next))));
    bytes.resize(run.end - run.begin);
    this->faults->Put(this->pages + run.begin, bytes.data(), bytes.size());
  }
}

void ChunkedVoxels::PutZeros(std::size_t unit)
{
  const BrickSource::Box box = this->units.BoxOf(unit);
  for (std::int64_t slice = box.lower[2]; slice < box.upper[2]; ++slice)
  {
    const VoxelUnits::Run run = this->units.RunOf(unit, slice);
    this->faults->PutZeros(this->pages + run.begin, run.end - run.begin);
  }
}

}
