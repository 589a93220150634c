#ifndef Varimarch_Readers_Decoder_DecoderSession_h
#define Varimarch_Readers_Decoder_DecoderSession_h

#include "VarimarchVolumeModule.h"

#include "Readers/Decoder/DecoderProcess.h"

#include <memory>

namespace varimarch
{

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
