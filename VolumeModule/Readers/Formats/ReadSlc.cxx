// SLC, the format of VolVis: a text header, an icon, then slices of bytes, perhaps run-length
// encoded. VTK's own reader, vtkSLCReader, writes beyond its memory if a slice's code is longer
// than the slice. In the decoder, that could still change the voxels without a word.
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Parsing/HeaderText.h"
#include "Readers/VoxelLayout.h"

#include <algorithm>

namespace varimarch
{
namespace
{

constexpr const char* slcMark = "11111";

struct SlcHeader
{
  std::string path;
  VoxelLayout layout;
  ImageGeometry geometry;
  bool isEncoded;
  std::size_t end; ///< offset of the first slice
};

/// Offset after a text such as "128 128 X", which ends at the letter.
std::size_t EndOfText(const SlcHeader& header, const std::string& bytes, std::size_t begin)
{
  const std::size_t letter = bytes.find('X', begin);
  if (letter == std::string::npos || letter - begin > 80)
  {
    FailToRead(header.path, "the letter X after a size", "none");
  }
  return letter + 1;
}

SlcHeader ReadSlcHeader(const std::string& path, const std::string& bytes)
{
  SlcHeader header = { path, { {}, VTK_UNSIGNED_CHAR }, {}, false, 0 };
  HeaderWords words(path, bytes);
  const std::string first = words.Next();
  if (first != slcMark)
  {
    FailToRead(path, "an SLC file, whose first number is 11111", Quoted(first));
  }
  for (std::int64_t& dimension : header.layout.dimensions)
  {
    dimension = words.Integer("whole dimensions");
  }
  const std::int64_t bits = words.Integer("a number of bits");
  if (bits != 8)
  {
    FailToRead(path, "voxels of 8 bits", std::to_string(bits));
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    header.geometry.axesMm[axis] *= words.Number("a spacing of numbers");
  }
  for (const char* const what : { "a unit", "an origin of the data", "a modification" })
  {
    words.Integer(what);
  }
  const std::int64_t compression = words.Integer("a compression");
  if (compression != 0 && compression != 1)
  {
    FailToRead(path, "the compression 0 or 1", std::to_string(compression));
  }
  header.isEncoded = compression == 1;
  const std::int64_t iconWidth = words.Integer("the width of an icon");
  const std::int64_t iconHeight = words.Integer("the height of an icon");
  if (iconWidth < 0 || iconWidth > 65535 || iconHeight < 0 || iconHeight > 65535)
  {
    FailToRead(path, "an icon of 0 to 65535 pixels along each side",
      std::to_string(iconWidth) + " x " + std::to_string(iconHeight));
  }
  // The icon has a plane for each of three colours.
  header.end = EndOfText(header, bytes, words.Position()) + 3 * std::size_t(iconWidth * iconHeight);
  return header;
}

/// Decodes a slice: runs of up to 127 bytes, which are equal unless the highest bit of the count is
/// set, until a count of 0.
/// @returns the number of decoded bytes, at most `count`
std::size_t Decode(const char* code, std::size_t codeBytes, char* slice, std::size_t count)
{
  std::size_t done = 0;
  for (std::size_t i = 0; i + 1 < codeBytes && (code[i] & 0x7f) != 0;)
  {
    const bool isLiteral = (code[i] & 0x80) != 0;
    const std::size_t length = std::min<std::size_t>(code[i] & 0x7f, count - done);
    const std::size_t taken = isLiteral ? std::min(length, codeBytes - i - 1) : length;
    isLiteral ? std::copy_n(code + i + 1, taken, slice + done)
              : std::fill_n(slice + done, taken, code[i + 1]);
    done += taken;
    i += isLiteral ? 1 + length : 2;
  }
  return done;
}

[[noreturn]] void FailAtSlice(const SlcHeader& header, std::int64_t slice)
{
  FailToRead(header.path, std::to_string(header.layout.dimensions[2]) + " complete slices",
    std::to_string(slice));
}

/// Copies or decodes a slice. @returns the offset after it
std::size_t TakeSlice(const SlcHeader& header, const std::string& bytes, std::size_t offset,
  std::int64_t slice, char* destination)
{
  const auto sliceBytes = std::size_t(header.layout.dimensions[0] * header.layout.dimensions[1]);
  if (offset > bytes.size())
  {
    FailAtSlice(header, slice);
  }
  std::size_t storedBytes = sliceBytes;
  std::size_t begin = offset;
  if (header.isEncoded)
  {
    const std::string size = bytes.substr(offset, 80);
    HeaderWords words(header.path, size);
    const std::int64_t stated = words.Integer("the size of slice " + std::to_string(slice));
    storedBytes = std::size_t(std::max<std::int64_t>(stated, 0));
    begin = EndOfText(header, bytes, offset);
  }
  if (begin > bytes.size() || storedBytes > bytes.size() - begin)
  {
    FailAtSlice(header, slice);
  }
  if (!header.isEncoded)
  {
    std::copy_n(bytes.data() + begin, sliceBytes, destination);
  }
  else if (Decode(bytes.data() + begin, storedBytes, destination, sliceBytes) < sliceBytes)
  {
    FailAtSlice(header, slice);
  }
  return begin + storedBytes;
}

}

bool IsSlc(const std::string& head)
{
  return head.compare(0, 5, slcMark) == 0 && head.size() > 5 && (head[5] == '\n' || head[5] == ' ');
}

Volume ReadSlc(const std::string& path, const ReadOptions&, ReadProgress& progress)
{
  const std::string bytes = WholeFile(path);
  const SlcHeader header = ReadSlcHeader(path, bytes);
  const double voxelBytes = double(CheckedByteCount(path, header.layout));
  // Two bytes encode at most 127.
  const double mostBytes = double(bytes.size()) * (header.isEncoded ? 64.0 : 1.0);
  if (voxelBytes > mostBytes)
  {
    FailToRead(path, ByteText(voxelBytes) + " of voxels", ByteText(double(bytes.size())));
  }
  Volume volume;
  volume.image = AllocatedImage(header.layout);
  auto* destination = static_cast<char*>(volume.image->GetScalarPointer());
  std::size_t offset = header.end;
  const std::int64_t sliceCount = header.layout.dimensions[2];
  for (std::int64_t slice = 0; slice < sliceCount; ++slice)
  {
    progress.Report(double(slice) / double(sliceCount));
    offset = TakeSlice(header, bytes, offset, slice, destination);
    destination += header.layout.dimensions[0] * header.layout.dimensions[1];
  }
  PlaceImage(path, header.geometry, volume.image);
  return volume;
}

}
