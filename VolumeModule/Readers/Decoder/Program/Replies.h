#ifndef Varimarch_Readers_Decoder_Program_Replies_h
#define Varimarch_Readers_Decoder_Program_Replies_h

#include "Readers/Decoder/Channel.h"
#include "Readers/VolumeFile.h"

#include <chrono>
#include <string>

namespace varimarch
{

/// The decoder's side of its connection.
class Replies
{
public:
  Replies(int socket, int memory)
    : channel(socket, memory)
  {
  }

  void Send(MessageKind kind, const std::string& content = {})
  {
    this->channel.Send(kind, content);
  }

  /// Waits for the next job.
  /// @throws ChannelClosed if the reader has ended
  std::string NextJob();

  /// Sends bytes after a result, in as many parts as they need. Memory that was sent is given back
  /// to the system, so that the volume is in memory only once; its content is lost.
  /// @throws ReadCancelled if the reader wants no more
  void SendBytes(char* bytes, std::uint64_t count);

  /// Memory for the next part of the bytes after a result.
  /// @throws ReadCancelled if the reader wants no more
  char* FreeHalf();
  /// Sends what was written to that memory.
  void SendHalf(std::size_t count, std::uint64_t fileBytes);

  /// A progress that is sent to the reader, which ends this process if it cancels.
  ReadProgress Progress();

private:
  Message Receive();

  Channel channel;
  int half = 0;
  int credits = Channel::HalfCount; ///< halves that the reader does not use
  std::chrono::steady_clock::time_point lastSign;
};

}

#endif
