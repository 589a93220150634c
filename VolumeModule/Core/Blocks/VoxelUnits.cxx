#include "Core/Blocks/VoxelUnits.h"

#include <algorithm>
#include <vector>

namespace varimarch
{
namespace
{

/// The least number of whole chunks along an axis that has enough of something, or all of the axis.
std::int64_t WholeChunks(std::int64_t chunk, std::int64_t all, double eachHas, double enough)
{
  std::int64_t count = chunk;
  while (count < all && double(count) * eachHas < enough)
  {
    count += chunk;
  }
  return std::min(count, all);
}

}

bool VoxelUnits::AreIn(
  const BrickSource::Level& level, std::size_t voxelBytes, std::size_t pageBytes)
{
  // The rows that a page reaches into are then in one slice.
  return double(level.dimensions[0]) * double(level.dimensions[1]) * double(voxelBytes) >=
    2.0 * double(pageBytes);
}

VoxelUnits::VoxelUnits(const BrickSource::Level& level, std::size_t voxelBytes,
  std::size_t pageBytes, double wantedBytes)
  : level(level)
  , rowBytes(std::uint64_t(level.dimensions[0]) * voxelBytes)
  , pageBytes(pageBytes)
  , rowsBehind(std::int64_t((pageBytes + rowBytes - 1) / rowBytes))
{
  const double rowOfChunks = double(this->rowBytes) * double(level.chunk[2]);
  this->rows = std::max(
    this->rowsBehind, WholeChunks(level.chunk[1], level.dimensions[1], rowOfChunks, wantedBytes));
  const double unitSlice = double(this->rowBytes) * double(this->rows);
  this->slices = WholeChunks(level.chunk[2], level.dimensions[2], unitSlice, wantedBytes);
  // A rest of fewer rows than a page may need belongs to the unit before it.
  const std::int64_t rest = level.dimensions[1] % this->rows;
  this->alongY = level.dimensions[1] / this->rows + (rest >= this->rowsBehind ? 1 : 0);
  this->alongZ = (level.dimensions[2] + this->slices - 1) / this->slices;
}

std::int64_t VoxelUnits::RowBehind(std::size_t unit) const
{
  const bool isLast = std::int64_t(unit) % this->alongY == this->alongY - 1;
  return isLast ? this->level.dimensions[1] : this->FirstRow(unit) + this->rows;
}

std::size_t VoxelUnits::UnitAt(std::uint64_t byte) const
{
  const auto row = std::int64_t(byte / this->rowBytes);
  const std::int64_t y = row % this->level.dimensions[1] / this->rows;
  const std::int64_t z = row / this->level.dimensions[1] / this->slices;
  return std::size_t(z * this->alongY + std::min(y, this->alongY - 1));
}

BrickSource::Box VoxelUnits::BoxOf(std::size_t unit) const
{
  const std::int64_t slice = std::int64_t(unit) / this->alongY * this->slices;
  return { { 0, this->FirstRow(unit), slice },
    { this->level.dimensions[0], this->RowBehind(unit),
      std::min(slice + this->slices, this->level.dimensions[2]) } };
}

std::optional<BrickSource::Box> VoxelUnits::BoxBehind(std::size_t unit) const
{
  BrickSource::Box box = this->BoxOf(unit);
  bool isWhole = true;
  for (std::int64_t slice = box.lower[2]; slice < box.upper[2]; ++slice)
  {
    isWhole = isWhole && this->ByteOfRow(box.upper[1], slice) % this->pageBytes == 0;
  }
  const bool goesOnInNextSlice = box.upper[1] == this->level.dimensions[1];
  box.lower[1] = goesOnInNextSlice ? 0 : box.upper[1];
  box.upper[1] = box.lower[1] + this->rowsBehind;
  box.lower[2] += goesOnInNextSlice ? 1 : 0;
  box.upper[2] = std::min(box.upper[2] + (goesOnInNextSlice ? 1 : 0), this->level.dimensions[2]);
  return isWhole || box.lower[2] >= box.upper[2] ? std::nullopt : std::optional(box);
}

VoxelUnits::Run VoxelUnits::RunOf(std::size_t unit, std::int64_t slice) const
{
  const auto upwards = [&](std::uint64_t byte)
  { return (byte + this->pageBytes - 1) / this->pageBytes * this->pageBytes; };
  return { upwards(this->ByteOfRow(this->FirstRow(unit), slice)),
    upwards(this->ByteOfRow(this->RowBehind(unit), slice)) };
}

std::uint64_t VoxelUnits::MostBytesFor(const BlockLevels& levels) const
{
  std::vector<bool> areRead(this->Count());
  const auto read = [&](std::int64_t y, std::int64_t z)
  {
    const std::int64_t side = levels.side;
    const std::int64_t lastY = std::min((y + 1) * side / this->rows, this->alongY - 1);
    const std::int64_t lastZ = std::min((z + 1) * side / this->slices, this->alongZ - 1);
    for (std::int64_t unitZ = z * side / this->slices; unitZ <= lastZ; ++unitZ)
    {
      for (std::int64_t unitY = std::min(y * side / this->rows, lastY); unitY <= lastY; ++unitY)
      {
        areRead[std::size_t(unitZ * this->alongY + unitY)] = true;
      }
    }
  };
  for (std::size_t row = 0; row < levels.ofBlocks.size(); row += std::size_t(levels.count.x))
  {
    const auto first = levels.ofBlocks.begin() + std::ptrdiff_t(row);
    const auto end = first + levels.count.x;
    if (std::find(first, end, BlockLevel::Voxels) != end)
    {
      const auto number = std::int64_t(row) / levels.count.x;
      read(number % levels.count.y, number / levels.count.y);
    }
  }
  return this->MostBytes() * std::uint64_t(std::count(areRead.begin(), areRead.end(), true));
}

}
