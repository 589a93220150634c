#include "Readers/Decoder/DecodedPyramid.h"

#include "Readers/Decoder/Conversation.h"
#include "Readers/Decoder/DecoderSession.h"
#include "Readers/Decoder/Fields.h"
#include "Readers/FileError.h"
#include "Readers/Times.h"
#include "Readers/VoxelLayout.h"

#include <vtkDataArray.h>

#include <algorithm>

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

}
