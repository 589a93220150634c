#ifndef Varimarch_Readers_PageMap_h
#define Varimarch_Readers_PageMap_h

#include <cstddef>

namespace varimarch
{

/// The number of bytes of a page of memory.
std::size_t PageBytes();

/// The pages of this process, as the system lists them.
class PageMap
{
public:
  PageMap();
  ~PageMap();
  PageMap(const PageMap&) = delete;
  void operator=(const PageMap&) = delete;

  /// Memory that dropping a part of a mapped file would free; 0 if this would lose pages that were
  /// written, or if the system does not tell.
  /// @param byteCount  whole pages
  std::size_t DroppableBytes(const char* begin, std::size_t byteCount) const;

private:
  int descriptor;
};

}

#endif
