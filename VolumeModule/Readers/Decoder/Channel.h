#ifndef Varimarch_Readers_Decoder_Channel_h
#define Varimarch_Readers_Decoder_Channel_h

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace varimarch
{

/// A file descriptor that is closed with its owner.
class OwnedDescriptor
{
public:
  explicit OwnedDescriptor(int descriptor = -1)
    : descriptor(descriptor)
  {
  }
  ~OwnedDescriptor();
  OwnedDescriptor(const OwnedDescriptor&) = delete;
  void operator=(const OwnedDescriptor&) = delete;

  int Get() const { return this->descriptor; }
  void Close();
  /// Closes the descriptor, and owns another one from now on.
  void Take(int other);

private:
  int descriptor;
};

/// The kinds of messages between a reader and its decoder.
enum class MessageKind : std::uint32_t
{
  Hello,     ///< the decoder has started; holds its version
  Job,       ///< an order of the reader
  Cancel,    ///< the reader wants no more of the job
  Credit,    ///< the reader has taken bytes out of a half of the shared memory
  Progress,  ///< holds the finished part
  Result,    ///< holds the values that the job returns
  Bytes,     ///< a half of the shared memory holds a part of the bytes that follow the result
  Done,      ///< the job is done
  Fault,     ///< the job has failed; holds a sentence
  NoMemory,  ///< the job has failed for want of memory
  Cancelled, ///< the job has ended after Cancel
};

struct Message
{
  MessageKind kind;
  std::string content;
};

/// The other side has ended.
struct ChannelClosed
{
};

/// One side of the connection of a reader and its decoder: messages through a socket, voxels
/// through memory that both share. The memory has two halves that are filled in turn.
class Channel
{
public:
  static constexpr std::size_t HalfBytes = std::size_t(8) << 20;
  static constexpr int HalfCount = 2;

  /// @param socket  socket of this side; not owned
  /// @param memory  file of HalfCount * HalfBytes bytes, which must not shrink; not owned
  /// @throws std::runtime_error if the memory cannot be mapped
  Channel(int socket, int memory);
  ~Channel();
  Channel(const Channel&) = delete;
  void operator=(const Channel&) = delete;

  /// @throws ChannelClosed
  void Send(MessageKind kind, const std::string& content = {});

  /// Waits for a message.
  /// @param waiting  called several times a second while there is none; may throw
  /// @throws ChannelClosed
  Message Receive(const std::function<void()>& waiting);

  char* Half(int index) { return this->memory + std::size_t(index) * HalfBytes; }

private:
  void ReceiveBytes(void* buffer, std::size_t count, const std::function<void()>& waiting);

  int socket;
  char* memory;
};

}

#endif
