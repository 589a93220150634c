#include "Readers/Images/TiffEntries.h"

#include "Readers/ByteStream.h"
#include "Readers/FileContent.h"

#include <algorithm>

namespace varimarch
{

TiffEntries::TiffEntries(const TiffFile& file)
  : path(file.Path())
  , isBigEndian(FirstBytes(file.Path()).compare(0, 1, "M") == 0)
{
  const std::uint64_t directory = file.Pages().front().directory;
  // A header of BigTIFF has the version 43.
  const bool isBig = this->BytesAt(0, 4).At<unsigned short>(2) == 43;
  const BinaryHeader begin = this->BytesAt(directory, 8);
  constexpr std::uint64_t MostEntries = 4096;
  const std::uint64_t count =
    std::min(MostEntries, isBig ? begin.At<std::uint64_t>(0) : begin.At<unsigned short>(0));
  const std::size_t entryBytes = isBig ? 20 : 12;
  const BinaryHeader bytes =
    this->BytesAt(directory + (isBig ? 8 : 2), std::size_t(count) * entryBytes);
  for (std::size_t at = 0; at + entryBytes <= bytes.Bytes().size(); at += entryBytes)
  {
    const TiffEntry entry = isBig
      ? TiffEntry{ bytes.At<unsigned short>(at + 2), bytes.At<std::uint64_t>(at + 4),
          bytes.At<std::uint64_t>(at + 12) }
      : TiffEntry{ bytes.At<unsigned short>(at + 2), bytes.At<std::uint32_t>(at + 4),
          bytes.At<std::uint32_t>(at + 8) };
    this->entries.emplace(bytes.At<unsigned short>(at), entry);
  }
}

std::optional<TiffEntry> TiffEntries::At(int tag) const
{
  const auto entry = this->entries.find(tag);
  return entry == this->entries.end() ? std::nullopt : std::optional(entry->second);
}

BinaryHeader TiffEntries::BytesAt(std::uint64_t offset, std::size_t count) const
{
  std::string bytes(count, '\0');
  bytes.resize(OpenStream(this->path, Compression::None, offset)->Read(bytes.data(), bytes.size()));
  return { std::move(bytes), this->isBigEndian };
}

}
