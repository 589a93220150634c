#include "Readers/TarArchive.h"

#include "Readers/FileError.h"

#include <cstring>
#include <numeric>

namespace varimarch
{
namespace
{

constexpr std::size_t blockBytes = 512;

/// The block before each member (POSIX.1-1988, which all later tar formats extend).
struct Header
{
  char name[100];
  char modeAndOwner[24];
  char size[12];
  char time[12];
  char checksum[8];
  char type;
  char rest[355];
};
static_assert(sizeof(Header) == blockBytes, "a tar header is one block");

/// A number in octal digits, or in base 256 (for more than 8 GB) if the first bit is set.
template <std::size_t Count>
std::uint64_t NumberFromField(const char (&field)[Count])
{
  const bool isBinary = (field[0] & 0x80) != 0;
  std::uint64_t number = 0;
  for (std::size_t i = isBinary ? 1 : 0; i < Count; ++i)
  {
    if (isBinary)
    {
      number = number * 256 + std::uint8_t(field[i]);
    }
    else if (field[i] >= '0' && field[i] <= '7')
    {
      number = number * 8 + std::uint64_t(field[i] - '0');
    }
  }
  return number;
}

/// The checksum is the sum of all bytes, with spaces in place of the checksum.
bool HasRightChecksum(const Header& header)
{
  Header blanked = header;
  std::memset(blanked.checksum, ' ', sizeof(blanked.checksum));
  const auto* bytes = reinterpret_cast<const unsigned char*>(&blanked);
  return std::accumulate(bytes, bytes + blockBytes, 0u) == NumberFromField(header.checksum);
}

std::string FileName(const Header& header)
{
  const std::string path(header.name, strnlen(header.name, sizeof(header.name)));
  return path.substr(path.find_last_of('/') + 1);
}

}

TarMember FindInTar(const std::string& path, const std::string& name)
{
  auto stream = OpenStream(path, CompressionOf(path));
  Header header;
  while (stream->Read(&header, blockBytes) == blockBytes && header.name[0] != '\0')
  {
    if (!HasRightChecksum(header))
    {
      FailToRead(path, "a tar archive", "a block that is not a tar header");
    }
    const std::uint64_t byteCount = NumberFromField(header.size);
    if (FileName(header) == name)
    {
      return { std::move(stream), byteCount };
    }
    // Members are padded to whole blocks.
    const std::uint64_t paddedBytes =
      (byteCount / blockBytes + (byteCount % blockBytes != 0)) * blockBytes;
    if (stream->Skip(paddedBytes) < paddedBytes)
    {
      break;
    }
  }
  FailToRead(path, "a tar archive with the file " + Quoted(name), "none of that name");
}

}
