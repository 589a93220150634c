#ifndef Varimarch_Readers_Decoder_DecoderProcess_h
#define Varimarch_Readers_Decoder_DecoderProcess_h

#include "Readers/Decoder/Channel.h"

#include <memory>
#include <string>

#include <sys/types.h>

namespace varimarch
{

/// A process of the program varimarch-decode, in which libraries that others maintain parse files
/// of strangers. It ends with this object, at once, whatever it does.
class DecoderProcess
{
public:
  /// Starts the process, without waiting for it.
  /// @throws std::runtime_error with words such as "no program ..." if it cannot be started
  DecoderProcess();
  ~DecoderProcess();
  DecoderProcess(const DecoderProcess&) = delete;
  void operator=(const DecoderProcess&) = delete;

  Channel& Messages() { return *this->channel; }

  /// True once the process has said that it is ready.
  bool isReady = false;

  /// Ends the process, and tells how it has ended, in words such as "the signal Aborted".
  std::string Ending();

  /// The program's file: that of the environment variable VARIMARCH_DECODER, or the one beside the
  /// library that this code is in.
  static std::string Program();

private:
  void Start(int socket);

  OwnedDescriptor socket;
  OwnedDescriptor memory;
  std::unique_ptr<Channel> channel;
  pid_t process = -1;
};

}

#endif
