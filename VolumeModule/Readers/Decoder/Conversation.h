#ifndef Varimarch_Readers_Decoder_Conversation_h
#define Varimarch_Readers_Decoder_Conversation_h

#include "Readers/Decoder/DecoderSession.h"
#include "Readers/Decoder/Jobs.h"
#include "Readers/Decoder/Wire.h"
#include "Readers/VolumeFile.h"

#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>

namespace varimarch
{

/// A decoder has crashed, was ended because it made no progress or took too much memory, or has
/// answered nonsense.
struct DecoderFailure
{
  std::string found; ///< as FailToRead has it
};

/// The reader in the decoder has failed, with a sentence; the decoder goes on.
struct DecoderFault : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Unpacks the content of a result.
/// @throws DecoderFailure if it is malformed
template <class... Values>
void TakeValues(const std::string& content, Values&... values)
{
  try
  {
    WireReader wire(content);
    wire(values...);
  }
  catch (const std::runtime_error&)
  {
    throw DecoderFailure{ "an answer of the decoder that makes no sense" };
  }
}

/// A part of the bytes that follow a result.
struct DecoderBytes
{
  const char* begin;
  std::size_t count;       ///< 0 at the end
  std::uint64_t fileBytes; ///< bytes of the file that were read up to here
};

/// Orders for one decoder, and its answers, which come in the order of the orders. A decoder that
/// has answered all of them serves the session further; any other ends with this object.
class Conversation
{
public:
  /// @param path  path for error messages
  /// @param progress  receives the progress of jobs; must outlive this object
  /// @throws std::runtime_error if no decoder can be started
  Conversation(const std::string& path, ReadProgress& progress);
  ~Conversation();
  Conversation(const Conversation&) = delete;
  void operator=(const Conversation&) = delete;

  /// @param order  a job and its arguments, see Job
  void Give(const std::string& order);

  /// The content of the next result. Its bytes, if any, and its end are still to come.
  /// @param expectedBytes  memory that the result needs, if known; each MB adds a second to the
  /// time that the decoder may take without progress
  /// @throws DecoderFault
  /// @throws DecoderFailure
  /// @throws ReadCancelled
  std::string Result(double expectedBytes = 0.0);

  /// The next part of the bytes, valid up to the next call; at the end the answer is finished.
  DecoderBytes NextBytes();

  /// Receives this number of bytes; a decoder that sends another number fails.
  void TakeBytes(void* destination, std::uint64_t count);

  /// Receives the end of an answer. The bytes that were received last stay valid.
  void Finish();

  /// Wants no more bytes of the only order.
  void Cancel() noexcept;

private:
  Message Next();
  void AwaitReadiness();
  /// The next message that is not about progress.
  Message AwaitMessage();
  [[noreturn]] void FailToStart(const std::string& found) const;
  /// Lets the decoder fill the half again whose bytes were received last.
  void ReleaseBytes();
  void CheckSilence();

  std::string path;
  ReadProgress& progress;
  std::unique_ptr<DecoderProcess> process;
  int openOrders = 0;
  bool holdsBytes = false;
  double finishedPart = 0.0;
  double expectedBytes = 0.0; ///< size of the answer that is being waited for
  std::chrono::steady_clock::time_point lastSign;
};

/// Fails with the reason why a decoder has.
[[noreturn]] void FailToDecode(const std::string& path, const DecoderFailure& failure);

/// The result of a single job without bytes.
/// @throws std::runtime_error also if the decoder fails
/// @throws ReadCancelled
template <class Value>
Value Answer(const std::string& path, const std::string& order, ReadProgress& progress)
{
  try
  {
    Conversation conversation(path, progress);
    conversation.Give(order);
    Value value;
    TakeValues(conversation.Result(), value);
    conversation.Finish();
    return value;
  }
  catch (const DecoderFailure& failure)
  {
    FailToDecode(path, failure);
  }
}

/// The most memory that a job may take if the size of its result is unknown [bytes]: all that is
/// free.
double FreeJobMemory();

/// The most memory that decoding a file may take [bytes]: several times the decoded content and the
/// file, since decoders keep wider values and copies, but at most what is free.
double JobMemory(const std::string& path, double decodedBytes, double freeBytes);

}

#endif
