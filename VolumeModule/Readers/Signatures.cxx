#include "Readers/Signatures.h"

#include "Readers/FileContent.h"
#include "Readers/Formats.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <numeric>

namespace varimarch
{
namespace
{

/// A 16-bit number of a little-endian file; 0 behind its end.
unsigned ShortAt(const std::string& head, std::size_t offset)
{
  const auto byteAt = [&](std::size_t place)
  { return place < head.size() ? unsigned(static_cast<unsigned char>(head[place])) : 0u; };
  return byteAt(offset) + 256 * byteAt(offset + 1);
}

bool IsPicture(const std::string& head)
{
  return IsPng(head) || IsJpeg(head) || IsBmp(head);
}

/// The mark of all tar formats, also those without the letters "ustar": a checksum in octal digits,
/// which counts its own field as blanks.
bool IsTar(const std::string& head)
{
  if (head.size() < 512)
  {
    return false;
  }
  const auto sum = [](unsigned before, unsigned char byte) { return before + byte; };
  const unsigned total = std::accumulate(head.begin(), head.begin() + 148, 0u, sum) + 8u * ' ' +
    std::accumulate(head.begin() + 156, head.begin() + 512, 0u, sum);
  return head[0] != '\0' &&
    std::strtoul(head.substr(148, 8).c_str(), nullptr, 8) == (unsigned long)(total);
}

}

bool IsDicom(const std::string& head)
{
  const unsigned group = ShortAt(head, 0);
  const bool hasGroup = head.size() > 8 && (group == 2 || group == 8);
  const bool isExplicit = hasGroup && std::isupper(static_cast<unsigned char>(head[4])) &&
    std::isupper(static_cast<unsigned char>(head[5]));
  const std::size_t next = 8 + ShortAt(head, 4);
  const bool isImplicit = hasGroup && ShortAt(head, 6) == 0 && ShortAt(head, 4) % 2 == 0 &&
    ShortAt(head, next) == group && ShortAt(head, next + 2) > ShortAt(head, 2);
  return TextAt(128, { "DICM" })(head) || isExplicit || isImplicit;
}

bool IsArchive(const std::string& head)
{
  return IsZip(head) || IsTar(head);
}

bool IsBmp(const std::string& head)
{
  // After the mark and the size of the file, four bytes are zero.
  return head.compare(0, 2, "BM") == 0 && head.size() >= 26 &&
    head.compare(6, 4, std::string(4, '\0')) == 0;
}

bool IsHdf5(const std::string& head)
{
  // A block of another program may stand before it, as in files of MATLAB.
  const std::string mark = "\x89HDF\r\n\x1a\n";
  const std::size_t places[] = { 0, 512, 1024, 2048 };
  return std::any_of(std::begin(places), std::end(places),
    [&](std::size_t place)
    { return place < head.size() && head.compare(place, mark.size(), mark) == 0; });
}

bool IsJpeg(const std::string& head)
{
  return head.compare(0, 3, "\xff\xd8\xff") == 0;
}

bool IsMinc(const std::string& head)
{
  return head.compare(0, 4, std::string("CDF\x01")) == 0 ||
    head.compare(0, 4, std::string("CDF\x02")) == 0 ||
    (IsHdf5(head) && head.find("minc-2.0") != std::string::npos);
}

bool IsPng(const std::string& head)
{
  return head.compare(0, 8, "\x89PNG\r\n\x1a\n") == 0;
}

bool IsStackSlice(const std::string& head)
{
  return IsPicture(head) || IsTiff(head);
}

bool IsTiff(const std::string& head)
{
  const std::string begin = head.substr(0, 4);
  return begin == std::string("II*\0", 4) || begin == std::string("MM\0*", 4) ||
    begin == std::string("II+\0", 4) || begin == std::string("MM\0+", 4);
}

bool IsZip(const std::string& head)
{
  return TextAt(0, { "PK\3\4", "PK\5\6", "PK00PK\3\4" })(head);
}

}
