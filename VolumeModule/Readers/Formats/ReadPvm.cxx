// PVM, the format of the V^3 volume renderer: a text header and the voxels, usually compressed as a
// whole. See the appendix of its documentation, http://www.stereofx.org/volume.html
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Parsing/HeaderText.h"
#include "Readers/VoxelFile.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace varimarch
{
namespace
{

constexpr std::size_t markBytes = 8;
constexpr const char* mark = "DDS v3d\n";

/// The mark of streams whose planes are interleaved in blocks.
constexpr const char* blockMark = "DDS v3e\n";

/// The bits of a string, highest first.
class BitStream
{
public:
  BitStream(const std::string& bytes, std::size_t begin)
    : bytes(bytes)
    , next(8 * std::uint64_t(begin))
  {
  }

  int Take(int bitCount)
  {
    int number = 0;
    for (int i = 0; i < bitCount; ++i, ++this->next)
    {
      const auto byte = std::size_t(this->next / 8);
      const int bit = byte < this->bytes.size() ? this->bytes[byte] >> (7 - this->next % 8) & 1 : 0;
      number = number << 1 | bit;
    }
    return number;
  }

  /// True if bits were taken after the end.
  bool IsBeyondEnd() const { return this->next > 8 * std::uint64_t(this->bytes.size()); }

private:
  const std::string& bytes;
  std::uint64_t next;
};

/// Undoes the separation of bytes into planes, of which `planeCount` make a value.
void JoinPlanes(char* bytes, std::size_t count, std::size_t planeCount)
{
  const std::string planes(bytes, count);
  std::size_t taken = 0;
  for (std::size_t plane = 0; plane < planeCount; ++plane)
  {
    for (std::size_t i = plane; i < count; i += planeCount)
    {
      bytes[i] = planes[taken++];
    }
  }
}

/// True if the bytes begin like a differential data stream (DDS) of the V^3 package.
bool IsDifferentialStream(const std::string& bytes)
{
  return bytes.compare(0, markBytes, mark) == 0 || bytes.compare(0, markBytes, blockMark) == 0;
}

/// Decodes a differential data stream: differences to the byte before and to the row before, with
/// as many bits as each run of them needs. The method is Stefan Roettger's,
/// http://www.stereofx.org.
/// @param path  path for the error message
/// @throws std::runtime_error if the stream ends early
std::string DecodedDifferentialStream(const std::string& path, const std::string& bytes)
{
  BitStream bits(bytes, markBytes);
  const auto planeCount = std::size_t(bits.Take(2) + 1);
  const auto rowBytes = std::size_t(bits.Take(16) + 1);
  std::string decoded;
  int value = 0;
  for (int runLength; (runLength = bits.Take(7)) != 0;)
  {
    const int width = bits.Take(3);
    const int bitCount = width > 0 ? width + 1 : 0;
    for (int i = 0; i < runLength; ++i)
    {
      const std::size_t count = decoded.size();
      value += bits.Take(bitCount) - (1 << bitCount) / 2;
      if (rowBytes > 1 && count > rowBytes)
      {
        value += static_cast<unsigned char>(decoded[count - rowBytes]) -
          static_cast<unsigned char>(decoded[count - rowBytes - 1]);
      }
      value &= 255;
      decoded += char(value);
    }
    if (bits.IsBeyondEnd())
    {
      FailToRead(path, "a complete compressed stream (DDS)",
        "its end after " + std::to_string(decoded.size()) + " decompressed bytes");
    }
  }
  const bool hasBlocks = bytes.compare(0, markBytes, blockMark) == 0;
  const std::size_t blockBytes =
    hasBlocks ? planeCount * (std::size_t(1) << 24) : std::max<std::size_t>(decoded.size(), 1);
  for (std::size_t begin = 0; planeCount > 1 && begin < decoded.size(); begin += blockBytes)
  {
    JoinPlanes(decoded.data() + begin, std::min(blockBytes, decoded.size() - begin), planeCount);
  }
  return decoded;
}

bool IsPlainPvm(const std::string& head)
{
  return head.compare(0, 4, "PVM\n") == 0 || head.compare(0, 5, "PVM2\n") == 0 ||
    head.compare(0, 5, "PVM3\n") == 0;
}

/// The bytes of a file, decompressed if necessary.
std::string DecodedFile(const std::string& path)
{
  std::string bytes = WholeFile(path);
  if (IsDifferentialStream(bytes))
  {
    bytes = DecodedDifferentialStream(path, bytes);
  }
  if (!IsPlainPvm(bytes))
  {
    FailToRead(path, "a PVM volume", "a file without its mark");
  }
  return bytes;
}

}

bool IsPvm(const std::string& head)
{
  return IsPlainPvm(head) || IsDifferentialStream(head);
}

Volume ReadPvm(const std::string& path, const ReadOptions&, ReadProgress& progress)
{
  const std::string bytes = DecodedFile(path);
  HeaderWords words(path, bytes);
  const bool hasSpacing = words.Next() != "PVM";
  VoxelLayout layout = { {}, VTK_VOID };
  for (std::int64_t& dimension : layout.dimensions)
  {
    dimension = words.Integer("whole dimensions");
  }
  ImageGeometry geometry;
  for (int axis = 0; hasSpacing && axis < 3; ++axis)
  {
    geometry.axesMm[axis] *= words.Number("a spacing of numbers");
  }
  // Two bytes are one number of 16 bits, highest byte first; more are colours.
  const std::int64_t valueBytes = words.Integer("a number of bytes per voxel");
  const bool isShort = valueBytes == 2;
  layout.scalarType = isShort ? VTK_UNSIGNED_SHORT : VTK_UNSIGNED_CHAR;
  layout.componentCount = isShort ? 1 : valueBytes;
  const std::uint64_t voxelBytes = CheckedByteCount(path, layout);
  const std::uint64_t leftBytes = bytes.size() - words.Position();
  if (leftBytes < voxelBytes)
  {
    FailToRead(path, ByteText(double(voxelBytes)) + " of voxels", ByteText(double(leftBytes)));
  }

  Volume volume;
  progress.Report(0.5);
  volume.image = AllocatedImage(layout);
  std::copy_n(bytes.data() + words.Position(), voxelBytes,
    static_cast<char*>(volume.image->GetScalarPointer()));
  SwapToHostOrder(true, volume.image);
  PlaceImage(path, geometry, volume.image);
  if (!hasSpacing)
  {
    volume.warnings.push_back(UnknownSpacing);
  }
  return volume;
}

}
