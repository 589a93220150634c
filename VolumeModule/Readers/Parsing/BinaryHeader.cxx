#include "Readers/Parsing/BinaryHeader.h"

#include "Readers/FileError.h"
#include "Readers/Packed/ByteStream.h"

#include <vtkByteSwap.h>

namespace varimarch
{

BinaryHeader::BinaryHeader(const std::string& path, std::size_t byteCount, bool isBigEndian)
  : bytes(byteCount, '\0')
  , isBigEndian(isBigEndian)
{
  ReadableFileSize(path);
  const std::size_t got =
    OpenStream(path, CompressionOf(path))->Read(this->bytes.data(), byteCount);
  if (got < byteCount)
  {
    FailToRead(path, "a header of " + std::to_string(byteCount) + " bytes", std::to_string(got));
  }
}

void BinaryHeader::Take(std::size_t offset, void* number, std::size_t byteCount) const
{
  if (offset > this->bytes.size() || byteCount > this->bytes.size() - offset)
  {
    return;
  }
  this->bytes.copy(static_cast<char*>(number), byteCount, offset);
#ifdef VTK_WORDS_BIGENDIAN
  const bool swaps = !this->isBigEndian;
#else
  const bool swaps = this->isBigEndian;
#endif
  if (swaps)
  {
    vtkByteSwap::SwapVoidRange(number, 1, byteCount);
  }
}

}
