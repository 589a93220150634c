#include "Readers/Decoder/Channel.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <stdexcept>

#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

namespace varimarch
{
namespace
{

struct MessageHead
{
  MessageKind kind;
  std::uint32_t reserved = 0;
  std::uint64_t byteCount = 0;
};

}

OwnedDescriptor::~OwnedDescriptor()
{
  this->Close();
}

void OwnedDescriptor::Close()
{
  if (this->descriptor >= 0)
  {
    close(this->descriptor);
  }
  this->descriptor = -1;
}

void OwnedDescriptor::Take(int other)
{
  this->Close();
  this->descriptor = other;
}

Channel::Channel(int socket, int memory)
  : socket(socket)
{
  void* const mapped =
    mmap(nullptr, HalfCount * HalfBytes, PROT_READ | PROT_WRITE, MAP_SHARED, memory, 0);
  if (mapped == MAP_FAILED)
  {
    throw std::runtime_error("memory cannot be shared");
  }
  this->memory = static_cast<char*>(mapped);
}

Channel::~Channel()
{
  munmap(this->memory, HalfCount * HalfBytes);
}

void Channel::Send(MessageKind kind, const std::string& content)
{
  const MessageHead head = { kind, 0, content.size() };
  std::string bytes(reinterpret_cast<const char*>(&head), sizeof(head));
  bytes += content;
  std::size_t done = 0;
  while (done < bytes.size())
  {
    // A closed socket is an error here, not a signal.
    const ssize_t sent = send(this->socket, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL);
    if (sent < 0 && errno != EINTR)
    {
      throw ChannelClosed();
    }
    done += std::size_t(std::max<ssize_t>(sent, 0));
  }
}

Message Channel::Receive(const std::function<void()>& waiting)
{
  MessageHead head = {};
  this->ReceiveBytes(&head, sizeof(head), waiting);
  constexpr std::uint64_t MostBytes = std::uint64_t(1) << 30;
  if (head.byteCount > MostBytes)
  {
    throw ChannelClosed();
  }
  // Content is taken as it comes, so that a false size costs no memory.
  std::array<char, 1 << 16> buffer;
  Message message = { head.kind, {} };
  while (message.content.size() < head.byteCount)
  {
    const std::size_t count =
      std::size_t(std::min<std::uint64_t>(buffer.size(), head.byteCount - message.content.size()));
    this->ReceiveBytes(buffer.data(), count, waiting);
    message.content.append(buffer.data(), count);
  }
  return message;
}

void Channel::ReceiveBytes(void* buffer, std::size_t count, const std::function<void()>& waiting)
{
  constexpr int WaitMs = 50;
  std::size_t done = 0;
  while (done < count)
  {
    pollfd state = { this->socket, POLLIN, 0 };
    const int ready = poll(&state, 1, WaitMs);
    if (ready <= 0)
    {
      waiting();
      continue;
    }
    const ssize_t got = recv(this->socket, static_cast<char*>(buffer) + done, count - done, 0);
    if (got == 0 || (got < 0 && errno != EINTR))
    {
      throw ChannelClosed();
    }
    done += std::size_t(std::max<ssize_t>(got, 0));
  }
}

}
