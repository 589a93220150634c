#include "Readers/Decoder/DecodedPyramid.h"

#include "Readers/Decoder/Conversation.h"
#include "Readers/Decoder/DecoderSession.h"
#include "Readers/Decoder/Fields.h"
#include "Readers/FileError.h"
#include "Readers/Times.h"
#include "Readers/VoxelLayout.h"

#include <vtkDataArray.h>

#include <algorithm>
#include <utility>

namespace varimarch
{
namespace
{

/// Requires what a decoder that read a forged file may not keep.
void CheckForm(const PyramidForm& form)
{
  const bool isComplete = !form.levels.empty() && form.geometries.size() == form.levels.size() &&
    IsNumberType(form.scalarType);
  const bool isCounted = std::all_of(form.levels.begin(), form.levels.end(),
    [](const BrickSource::Level& level)
    {
      return *std::min_element(level.dimensions.begin(), level.dimensions.end()) > 0 &&
        *std::min_element(level.chunk.begin(), level.chunk.end()) > 0;
    });
  if (!isComplete || !isCounted)
  {
    throw DecoderFailure{ "a description of the decoder that makes no sense" };
  }
}

/// The patience of the session that this thread is in.
double PatienceSeconds()
{
  const DecoderSession* const outer = DecoderSession::Current();
  return outer ? outer->LongestSilence() : DecoderSession::UsualSilenceSeconds;
}

template <class Number>
void ConvertToFloat(const Number* from, std::int64_t count, float* to)
{
  std::transform(from, from + count, to, [](Number number) { return float(number); });
}

}

DecodedPyramid::DecodedPyramid(const PyramidOrder& order, ReadProgress& progress)
  : order(order)
{
  try
  {
    DecoderSession session(PatienceSeconds());
    {
      Conversation conversation(order.path, progress);
      conversation.Give(Packed(Job::OpenPyramid, FreeJobMemory(), order));
      TakeValues(conversation.Result(), this->form);
      conversation.Finish();
    }
    CheckForm(this->form);
    CheckTime(order.path, this->form.times, order.options);
    this->idle.push_back(session.Idle());
  }
  catch (const DecoderFailure& failure)
  {
    FailToDecode(order.path, failure);
  }
}

DecodedPyramid::~DecodedPyramid() = default;

// Voxels of other types are converted to floats.
VoxelType DecodedPyramid::Type() const
{
  return VoxelTypeOf(this->form.scalarType).value_or(VoxelType::Float32);
}

std::int64_t DecodedPyramid::ReadConverted(int level, const Box& box, void* voxels) const
{
  ReadProgress silent([](double) { return true; });
  const int type = this->form.scalarType;
  if (VoxelTypeOf(type))
  {
    return this->ReadStored(level, box, voxels, silent);
  }
  const std::int64_t count = VoxelCount(box);
  std::vector<char> stored(std::size_t(count) * std::size_t(vtkDataArray::GetDataTypeSize(type)));
  const std::int64_t missing = this->ReadStored(level, box, stored.data(), silent);
  switch (type)
  {
    vtkTemplateMacro(ConvertToFloat(
      reinterpret_cast<const VTK_TT*>(stored.data()), count, static_cast<float*>(voxels)));
  }
  return missing;
}

std::int64_t DecodedPyramid::ReadStored(
  int level, const Box& box, void* voxels, ReadProgress& progress) const
{
  const std::int64_t bytes =
    VoxelCount(box) * std::int64_t(vtkDataArray::GetDataTypeSize(this->form.scalarType));
  std::int64_t missing = 0;
  this->Ask(progress,
    [&](Conversation& conversation)
    {
      conversation.Give(Packed(Job::ReadBox, FreeJobMemory(), this->order, level, box));
      TakeValues(conversation.Result(double(bytes)), missing);
      conversation.TakeBytes(voxels, std::uint64_t(bytes));
    });
  return missing;
}

StoredChunks DecodedPyramid::Stored(int level) const
{
  ReadProgress silent([](double) { return true; });
  StoredChunks chunks;
  this->Ask(silent,
    [&](Conversation& conversation)
    {
      conversation.Give(Packed(Job::FindChunks, FreeJobMemory(), this->order, level));
      TakeValues(conversation.Result(), chunks);
    });
  return chunks;
}

void DecodedPyramid::Ask(
  ReadProgress& progress, const std::function<void(Conversation&)>& talk) const
{
  std::unique_ptr<DecoderProcess> process;
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    if (!this->idle.empty())
    {
      process = std::move(this->idle.back());
      this->idle.pop_back();
    }
  }
  if (process)
  {
    try
    {
      this->TryToAsk(progress, talk, std::move(process));
      return;
    }
    catch (const DecoderFailure&)
    {
      // A decoder ends with the thread that started it, which may have been another one.
    }
  }
  try
  {
    this->TryToAsk(progress, talk, nullptr);
  }
  catch (const DecoderFailure& failure)
  {
    FailToDecode(this->order.path, failure);
  }
}

void DecodedPyramid::TryToAsk(ReadProgress& progress,
  const std::function<void(Conversation&)>& talk, std::unique_ptr<DecoderProcess> process) const
{
  DecoderSession session(PatienceSeconds());
  session.Return(process ? std::move(process) : std::make_unique<DecoderProcess>());
  {
    Conversation conversation(this->order.path, progress);
    talk(conversation);
    conversation.Finish();
  }
  const std::lock_guard<std::mutex> lock(this->mutex);
  this->idle.push_back(session.Idle());
}

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
