#include "Scene/ContentDigest.h"

#include <vtksys/MD5.h>

#include <algorithm>

namespace varimarch
{

ContentDigest::ContentDigest()
  : md5(vtksysMD5_New())
{
  vtksysMD5_Initialize(this->md5);
}

ContentDigest::~ContentDigest()
{
  vtksysMD5_Delete(this->md5);
}

void ContentDigest::AddBytes(const void* bytes, std::size_t count)
{
  // vtksysMD5_Append counts in int.
  constexpr std::size_t most = std::size_t(1) << 30;
  const auto* next = static_cast<const unsigned char*>(bytes);
  while (count > 0)
  {
    const std::size_t part = std::min(count, most);
    vtksysMD5_Append(this->md5, next, int(part));
    next += part;
    count -= part;
  }
}

std::string ContentDigest::Text()
{
  std::string text(32, '\0');
  vtksysMD5_FinalizeHex(this->md5, text.data());
  return text;
}

}
