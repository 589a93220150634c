#include "Readers/Decoder/Program/Replies.h"

#include "Readers/Decoder/Wire.h"

#include <algorithm>
#include <cstring>

#include <sys/mman.h>
#include <unistd.h>

namespace varimarch
{
namespace
{

/// Gives back the pages that lie between two places, if there are many.
void GiveBackPages(char* begin, std::size_t count)
{
  if (count < Channel::HalfBytes)
  {
    return;
  }
  const auto pageBytes = std::uintptr_t(sysconf(_SC_PAGESIZE));
  const std::uintptr_t first =
    (reinterpret_cast<std::uintptr_t>(begin) + pageBytes - 1) / pageBytes * pageBytes;
  const std::uintptr_t end =
    reinterpret_cast<std::uintptr_t>(begin + count) / pageBytes * pageBytes;
  madvise(reinterpret_cast<void*>(first), end - first, MADV_DONTNEED);
}

}

Message Replies::Receive()
{
  return this->channel.Receive([] {});
}

std::string Replies::NextJob()
{
  for (;;)
  {
    Message message = this->Receive();
    if (message.kind == MessageKind::Job)
    {
      return std::move(message.content);
    }
    // A Cancel that comes here was sent before its job was known to be done.
    this->credits += message.kind == MessageKind::Credit ? 1 : 0;
  }
}

char* Replies::FreeHalf()
{
  while (this->credits == 0)
  {
    const MessageKind kind = this->Receive().kind;
    if (kind == MessageKind::Cancel)
    {
      throw ReadCancelled();
    }
    this->credits += kind == MessageKind::Credit ? 1 : 0;
  }
  return this->channel.Half(this->half);
}

void Replies::SendHalf(std::size_t count, std::uint64_t fileBytes)
{
  this->Send(
    MessageKind::Bytes, Packed(std::uint32_t(this->half), std::uint64_t(count), fileBytes));
  this->half = (this->half + 1) % Channel::HalfCount;
  --this->credits;
}

void Replies::SendBytes(char* bytes, std::uint64_t count)
{
  for (std::uint64_t done = 0; done < count;)
  {
    const auto part = std::size_t(std::min<std::uint64_t>(count - done, Channel::HalfBytes));
    std::memcpy(this->FreeHalf(), bytes + done, part);
    this->SendHalf(part, 0);
    GiveBackPages(bytes + done, part);
    done += part;
  }
}

ReadProgress Replies::Progress()
{
  return ReadProgress(
    [this](double partDone)
    {
      constexpr auto Pause = std::chrono::milliseconds(20);
      const auto now = std::chrono::steady_clock::now();
      if (now - this->lastSign > Pause)
      {
        this->lastSign = now;
        this->Send(MessageKind::Progress, Packed(partDone));
      }
      return true;
    });
}

}
