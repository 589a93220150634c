#ifndef Varimarch_Scene_ContentDigest_h
#define Varimarch_Scene_ContentDigest_h

#include <cstddef>
#include <string>
#include <type_traits>

struct vtksysMD5_s;

namespace varimarch
{

/// The MD5 of a sequence of values: tells contents apart and finds damage. Not for security.
class ContentDigest
{
public:
  ContentDigest();
  ~ContentDigest();
  ContentDigest(const ContentDigest&) = delete;
  void operator=(const ContentDigest&) = delete;

  void AddBytes(const void* bytes, std::size_t count);

  /// A number or enumeration, by its bits.
  template <class Number>
  void Add(Number number)
  {
    static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>);
    this->AddBytes(&number, sizeof(number));
  }

  /// 32 letters and digits; nothing can be added after it.
  std::string Text();

private:
  vtksysMD5_s* md5;
};

}

#endif
