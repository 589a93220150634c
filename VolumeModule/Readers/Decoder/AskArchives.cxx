// Archives and compressed streams, as a decoder unpacks them.
#include "Readers/ByteStream.h"
#include "Readers/Decoder/Conversation.h"
#include "Readers/Decoder/Fields.h"
#include "Readers/Unpacking.h"

#include <algorithm>

namespace varimarch
{
namespace
{

/// The bytes that a decoder decompresses.
class DecodedStream : public ByteStream
{
public:
  DecodedStream(const std::string& path, std::uint64_t offset)
    : path(path)
    , silent([](double) { return true; })
    , conversation(path, this->silent)
  {
    this->Try(
      [&]
      {
        this->conversation.Give(Packed(Job::Decompress, FreeJobMemory(), path, offset));
        this->conversation.Result();
      });
  }

  ~DecodedStream() override
  {
    if (!this->ended)
    {
      this->conversation.Cancel();
    }
  }

  std::size_t Read(void* buffer, std::size_t count) override
  {
    std::size_t done = 0;
    while (done < count && !this->ended)
    {
      const std::size_t taken = std::min(count - done, this->part.count);
      std::copy_n(this->part.begin, taken, static_cast<char*>(buffer) + done);
      this->part.begin += taken;
      this->part.count -= taken;
      done += taken;
      if (this->part.count == 0 && done < count)
      {
        this->Try([&] { this->part = this->conversation.NextBytes(); });
        this->ended = this->part.count == 0;
        this->fileBytes = std::max(this->fileBytes, this->part.fileBytes);
      }
    }
    return done;
  }

  std::uint64_t FileBytes() override { return this->fileBytes; }

private:
  /// A stream that has failed has ended.
  template <class Action>
  void Try(const Action& action)
  {
    this->ended = true;
    try
    {
      action();
      this->ended = false;
    }
    catch (const DecoderFailure& failure)
    {
      FailToDecode(this->path, failure);
    }
  }

  std::string path;
  ReadProgress silent;
  Conversation conversation;
  DecoderBytes part = { nullptr, 0, 0 };
  std::uint64_t fileBytes = 0;
  bool ended = false;
};

}

std::unique_ptr<ByteStream> OpenArchiveStream(const std::string& path, std::uint64_t offset)
{
  return std::make_unique<DecodedStream>(path, offset);
}

UnpackedContent Unpack(const UnpackingOrder& order, ReadProgress& progress)
{
  return Answer<UnpackedContent>(order.path, Packed(Job::Unpack, FreeJobMemory(), order), progress);
}

}
