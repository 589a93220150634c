#ifndef Varimarch_Readers_Decoder_DecoderSession_h
#define Varimarch_Readers_Decoder_DecoderSession_h

#include "Readers/Decoder/Channel.h"
#include "VarimarchVolumeModule.h"

#include <sys/types.h>

#include <memory>
#include <string>

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

/// The time during which the reads of a thread share a decoder, which is started when the first of
/// them needs it. Without a session each job has a decoder of its own. A session within another one
/// uses that one's decoder, and has its own patience.
class VARIMARCHVOLUME_EXPORT DecoderSession
{
public:
  static constexpr double UsualSilenceSeconds = 60.0;

  /// @param longestSilence  longest time that a job may take without progress [s]
  explicit DecoderSession(double longestSilence = UsualSilenceSeconds);
  ~DecoderSession();
  DecoderSession(const DecoderSession&) = delete;
  void operator=(const DecoderSession&) = delete;

  /// The session of this thread, or null.
  static DecoderSession* Current();

  /// A decoder without a job: the one that was returned, or a new one.
  std::unique_ptr<DecoderProcess> Idle();
  void Return(std::unique_ptr<DecoderProcess> process) { this->idle = std::move(process); }

  double LongestSilence() const { return this->longestSilence; }
  /// Halves the time for further jobs, down to five seconds, so that a series of files that all
  /// hang does not take hours.
  void LosePatience();

private:
  DecoderSession* outer;
  double longestSilence;
  std::unique_ptr<DecoderProcess> idle;
};

}

#endif
