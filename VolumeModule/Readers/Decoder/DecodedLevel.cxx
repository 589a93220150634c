#include "Readers/Decoder/DecodedLevel.h"

#include "Readers/FileError.h"

#include <algorithm>
#include <utility>

namespace varimarch
{
namespace
{

BrickSource::Box Common(const BrickSource::Box& one, const BrickSource::Box& other)
{
  BrickSource::Box common;
  for (int axis = 0; axis < 3; ++axis)
  {
    common.lower[axis] = std::max(one.lower[axis], other.lower[axis]);
    common.upper[axis] = std::min(one.upper[axis], other.upper[axis]);
  }
  return common;
}

}

DecodedLevel::DecodedLevel(std::shared_ptr<const DecodedPyramid> newPyramid, int level)
  : pyramid(std::move(newPyramid))
  , level(level)
  , levels({ this->pyramid->Levels()[std::size_t(level)] })
  , chunks(this->pyramid->Stored(level))
{
  this->levels.front().scale = { 1.0, 1.0, 1.0 };
  const std::array<std::int64_t, 3> count = ChunkCount(this->levels.front());
  if (std::int64_t(this->chunks.areThere.size()) != count[0] * count[1] * count[2])
  {
    this->chunks.areThere.clear();
  }
}

template <class Take>
void DecodedLevel::EachChunk(const Box& box, Take take) const
{
  const Level& form = this->levels.front();
  const std::array<std::int64_t, 3> count = ChunkCount(form);
  std::array<std::int64_t, 3> first;
  std::array<std::int64_t, 3> last;
  for (int axis = 0; axis < 3; ++axis)
  {
    first[axis] = box.lower[axis] / form.chunk[axis];
    last[axis] = (box.upper[axis] - 1) / form.chunk[axis];
  }
  std::array<std::int64_t, 3> at;
  for (at[2] = first[2]; at[2] <= last[2]; ++at[2])
  {
    for (at[1] = first[1]; at[1] <= last[1]; ++at[1])
    {
      for (at[0] = first[0]; at[0] <= last[0]; ++at[0])
      {
        const auto number = std::size_t((at[2] * count[1] + at[1]) * count[0] + at[0]);
        take(at, this->chunks.areThere[number] != 0);
      }
    }
  }
}

void DecodedLevel::Read(int, const Box& box, void* voxels) const
{
  const std::int64_t missing = this->pyramid->ReadConverted(this->level, box, voxels);
  if (this->chunks.areThere.empty())
  {
    return; // nobody knows which were stored
  }
  std::int64_t expected = 0;
  this->EachChunk(box, [&](const auto&, bool isThere) { expected += isThere ? 0 : 1; });
  if (missing > expected)
  {
    FailToRead(this->pyramid->Path(), "the chunks that it had when it was opened",
      std::to_string(missing - expected) + " of them gone");
  }
}

BrickSource::Box DecodedLevel::Occupied(const Box& box) const
{
  if (this->chunks.areThere.empty())
  {
    return box;
  }
  const Level& form = this->levels.front();
  Box stored = { box.upper, box.lower };
  this->EachChunk(box,
    [&](const std::array<std::int64_t, 3>& at, bool isThere)
    {
      for (int axis = 0; isThere && axis < 3; ++axis)
      {
        const std::int64_t begin = at[axis] * form.chunk[axis];
        stored.lower[axis] = std::min(stored.lower[axis], begin);
        stored.upper[axis] = std::max(stored.upper[axis], begin + form.chunk[axis]);
      }
    });
  const bool isEmpty = stored.lower[0] >= stored.upper[0];
  return isEmpty ? Box{ box.lower, box.lower } : Common(stored, box);
}

std::int64_t DecodedLevel::MissingChunks() const
{
  return std::count(this->chunks.areThere.begin(), this->chunks.areThere.end(), 0);
}

}
