#ifndef Varimarch_Readers_Parsing_Nesting_h
#define Varimarch_Readers_Parsing_Nesting_h

#include <cstddef>
#include <string>

namespace varimarch
{

/// The most elements of a text in XML, or objects of a binary property list, that are read. VTK and
/// libplist recurse into them, and would exhaust the stack of 8 MB at 60,000 levels. A file has
/// fewer levels than elements; files of programs have a few thousand.
constexpr std::size_t MostNestedElements = 30000;

/// The number of objects that the trailer of a binary property list promises.
inline std::size_t PromisedObjects(const std::string& bytes)
{
  constexpr std::size_t PlaceFromEnd = 24;
  constexpr std::size_t HeadAndTrailerBytes = 8 + 32;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 8 && bytes.size() >= HeadAndTrailerBytes; ++i)
  {
    count = 256 * count + static_cast<unsigned char>(bytes[bytes.size() - PlaceFromEnd + i]);
  }
  return count;
}

/// True for more than MostNestedElements, in XML or in a binary property list.
inline bool MayBeNestedTooDeep(const std::string& bytes)
{
  if (bytes.compare(0, 6, "bplist") == 0)
  {
    return PromisedObjects(bytes) > MostNestedElements;
  }
  std::size_t count = 0;
  for (std::size_t place = bytes.find('<'); place != std::string::npos;
       place = bytes.find('<', place + 1))
  {
    const char next = place + 1 < bytes.size() ? bytes[place + 1] : '/';
    count += next != '/' && next != '!' && next != '?' ? 1 : 0;
  }
  return count > MostNestedElements;
}

}

#endif
