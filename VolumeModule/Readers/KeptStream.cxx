#include "Readers/KeptStream.h"

namespace varimarch
{

std::unique_ptr<ByteStream> KeptStream::TakeAt(const std::string& wantedPath,
  Compression compression, std::uint64_t wantedOffset, std::uint64_t wantedPosition)
{
  const bool isBefore = this->stream && this->path == wantedPath && this->offset == wantedOffset &&
    this->position <= wantedPosition;
  auto taken =
    isBefore ? std::move(this->stream) : OpenStream(wantedPath, compression, wantedOffset);
  taken->Skip(wantedPosition - (isBefore ? this->position : 0));
  return taken;
}

void KeptStream::Keep(const std::string& keptPath, std::uint64_t keptOffset,
  std::uint64_t keptPosition, std::unique_ptr<ByteStream> kept)
{
  this->path = keptPath;
  this->offset = keptOffset;
  this->position = keptPosition;
  this->stream = std::move(kept);
}

}
