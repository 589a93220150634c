#include "Readers/Decoder/Conversation.h"

#include "Readers/Decoder/DecoderSession.h"
#include "Readers/FileError.h"
#include "Readers/VoxelLayout.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace varimarch
{
namespace
{

using Clock = std::chrono::steady_clock;

std::unique_ptr<DecoderProcess> IdleProcess()
{
  DecoderSession* const session = DecoderSession::Current();
  return session ? session->Idle() : std::make_unique<DecoderProcess>();
}

double LongestSilence()
{
  const DecoderSession* const session = DecoderSession::Current();
  return session ? session->LongestSilence() : DecoderSession::UsualSilenceSeconds;
}

}

Conversation::Conversation(const std::string& path, ReadProgress& progress)
  : path(path)
  , progress(progress)
{
  try
  {
    this->process = IdleProcess();
  }
  catch (const std::runtime_error& error)
  {
    this->FailToStart(error.what());
  }
}

Conversation::~Conversation()
{
  DecoderSession* const session = DecoderSession::Current();
  if (session && this->process && this->openOrders == 0)
  {
    this->ReleaseBytes();
    session->Return(std::move(this->process));
  }
}

void Conversation::FailToStart(const std::string& found) const
{
  FailToRead(this->path,
    "the program \"" + DecoderProcess::Program() + "\" of Varimarch " + DecoderVersion() +
      ", which decodes such files (install it beside the library, or name it in the environment "
      "variable VARIMARCH_DECODER)",
    found);
}

void Conversation::Give(const std::string& order)
{
  ++this->openOrders;
  try
  {
    this->process->Messages().Send(MessageKind::Job, order);
  }
  catch (const ChannelClosed&)
  {
    // The answer that is missing tells why.
  }
}

std::string Conversation::Result(double bytes)
{
  this->expectedBytes = bytes;
  Message message = this->Next();
  if (message.kind != MessageKind::Result)
  {
    throw DecoderFailure{ "an answer of the decoder that makes no sense" };
  }
  return std::move(message.content);
}

DecoderBytes Conversation::NextBytes()
{
  this->ReleaseBytes();
  const Message message = this->Next();
  if (message.kind == MessageKind::Done)
  {
    --this->openOrders;
    return { nullptr, 0, 0 };
  }
  std::uint64_t count = 0;
  std::uint64_t fileBytes = 0;
  std::uint32_t half = 0;
  TakeValues(message.kind == MessageKind::Bytes ? message.content : "", half, count, fileBytes);
  if (count < 1 || count > Channel::HalfBytes || half >= Channel::HalfCount)
  {
    throw DecoderFailure{ "bytes of the decoder that make no sense" };
  }
  this->holdsBytes = true;
  return { this->process->Messages().Half(int(half)), std::size_t(count), fileBytes };
}

void Conversation::TakeBytes(void* destination, std::uint64_t count)
{
  auto* const begin = static_cast<char*>(destination);
  for (std::uint64_t done = 0; done < count;)
  {
    const DecoderBytes bytes = this->NextBytes();
    if (bytes.count == 0 || bytes.count > count - done)
    {
      throw DecoderFailure{ "another number of bytes than the decoder had promised" };
    }
    std::memcpy(begin + done, bytes.begin, bytes.count);
    done += bytes.count;
  }
}

void Conversation::Finish()
{
  if (this->Next().kind != MessageKind::Done)
  {
    throw DecoderFailure{ "a longer answer than the decoder had promised" };
  }
  --this->openOrders;
}

void Conversation::Cancel() noexcept
{
  try
  {
    this->ReleaseBytes();
    this->process->Messages().Send(MessageKind::Cancel);
    for (bool isOver = false; !isOver;)
    {
      const MessageKind kind = this->AwaitMessage().kind;
      this->holdsBytes = kind == MessageKind::Bytes;
      this->ReleaseBytes();
      isOver = kind != MessageKind::Bytes && kind != MessageKind::Result;
    }
    --this->openOrders;
  }
  catch (...)
  {
    // The order stays open, so that the decoder ends.
  }
}

Message Conversation::Next()
{
  try
  {
    Message message = this->AwaitMessage();
    if (message.kind == MessageKind::NoMemory)
    {
      throw DecoderFailure{ "data for which the decoder needs more memory than it may take" };
    }
    if (message.kind == MessageKind::Fault)
    {
      --this->openOrders;
      throw DecoderFault(message.content);
    }
    return message;
  }
  catch (const ChannelClosed&)
  {
    const std::string ending = this->process->Ending();
    if (!this->process->isReady)
    {
      this->FailToStart("one that ends at once, with " + ending);
    }
    throw DecoderFailure{ "data at which the decoder ends, with " + ending };
  }
}

Message Conversation::AwaitMessage()
{
  this->AwaitReadiness();
  this->lastSign = Clock::now();
  for (;;)
  {
    Message message = this->process->Messages().Receive([this] { this->CheckSilence(); });
    if (message.kind != MessageKind::Progress)
    {
      return message;
    }
    this->lastSign = Clock::now();
    std::memcpy(&this->finishedPart, message.content.data(),
      std::min(sizeof(this->finishedPart), message.content.size()));
    this->finishedPart = this->finishedPart > 0.0 ? std::min(this->finishedPart, 1.0) : 0.0;
    this->progress.Report(this->finishedPart);
  }
}

void Conversation::AwaitReadiness()
{
  if (this->process->isReady)
  {
    return;
  }
  this->lastSign = Clock::now();
  const Message hello = this->process->Messages().Receive([this] { this->CheckSilence(); });
  if (hello.kind != MessageKind::Hello || hello.content != DecoderVersion())
  {
    this->FailToStart("another one");
  }
  this->process->isReady = true;
}

void Conversation::ReleaseBytes()
{
  if (this->holdsBytes)
  {
    this->holdsBytes = false;
    try
    {
      this->process->Messages().Send(MessageKind::Credit);
    }
    catch (const ChannelClosed&)
    {
      // The next message that is missing tells why.
    }
  }
}

void Conversation::CheckSilence()
{
  // The user may cancel in the meantime.
  this->progress.Report(this->finishedPart);
  const double limit = LongestSilence() + 1e-6 * this->expectedBytes;
  const double silence = std::chrono::duration<double>(Clock::now() - this->lastSign).count();
  if (silence > limit)
  {
    if (DecoderSession* const session = DecoderSession::Current())
    {
      session->LosePatience();
    }
    char seconds[32];
    std::snprintf(seconds, sizeof(seconds), "%.3g", limit);
    throw DecoderFailure{ std::string("data with which the decoder makes no progress for ") +
      seconds + " seconds" };
  }
}

void FailToDecode(const std::string& path, const DecoderFailure& failure)
{
  FailToRead(path, "a file that can be decoded", failure.found + " (the file may be damaged)");
}

double FreeJobMemory()
{
  return FreeMemoryBytes();
}

double JobMemory(const std::string& path, double decodedBytes, double freeBytes)
{
  constexpr double Least = 256e6;
  constexpr double CopiesOfResult = 8.0;
  constexpr double CopiesOfFile = 4.0;
  std::error_code ignored;
  const auto fileBytes = std::filesystem::file_size(path, ignored);
  return std::min(freeBytes,
    Least + CopiesOfResult * decodedBytes + (ignored ? 0.0 : CopiesOfFile * double(fileBytes)));
}

}
