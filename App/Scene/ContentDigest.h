#ifndef Varimarch_Scene_ContentDigest_h
#define Varimarch_Scene_ContentDigest_h

#include <cstddef>
#include <string>
#include <type_traits>

struct vtksysMD5_s;

namespace varimarch
{

/// MD5 digest of a sequence of values, for cache keys and to detect damaged files. Not for
/// security.
class ContentDigest
{
public:
  ContentDigest();
  ~ContentDigest();
  ContentDigest(const ContentDigest&) = delete;
  void operator=(const ContentDigest&) = delete;

  void AddBytes(const void* bytes, std::size_t count);

  /// Adds the bits of a number or enumerator.
  template <class Number>
  void Add(Number number)
  {
    static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>);
    this->AddBytes(&number, sizeof(number));
  }

  /// The digest as 32 hexadecimal digits. Nothing can be added afterwards.
  std::string Text();

private:
  vtksysMD5_s* md5;
};

}

#endif
