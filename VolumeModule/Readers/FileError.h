#ifndef Varimarch_Readers_FileError_h
#define Varimarch_Readers_FileError_h

#include <cstddef>
#include <cstdint>
#include <string>

namespace varimarch
{

/// Throws the one sentence that every reader speaks:
/// Cannot read "path": expected <expected>, found <found>.
/// @throws std::runtime_error always
[[noreturn]] void FailToRead(
  const std::string& path, const std::string& expected, const std::string& found);

/// A piece of a file for use in a sentence, quoted: cut, unprintable characters and quotes as '?'.
/// @param longest  number of characters after which it is cut
std::string Quoted(const std::string& text, std::size_t longest = 40);

/// Size of a file that exists and can be read [bytes].
/// @throws std::runtime_error when it is missing, not a file, or not readable
std::uint64_t ReadableFileSize(const std::string& path);

}

#endif
