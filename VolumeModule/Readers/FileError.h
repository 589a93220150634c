#ifndef Varimarch_Readers_FileError_h
#define Varimarch_Readers_FileError_h

#include <cstddef>
#include <cstdint>
#include <string>

namespace varimarch
{

/// Throws the error that all readers use: Cannot read "path": expected <expected>, found <found>.
/// @throws std::runtime_error always
[[noreturn]] void FailToRead(
  const std::string& path, const std::string& expected, const std::string& found);

/// A part of a file, quoted for use in a sentence. Long text is cut; unprintable characters and
/// quotes become '?'.
/// @param longest  largest number of characters that remain
std::string Quoted(const std::string& text, std::size_t longest = 40);

/// Size of a file [bytes].
/// @throws std::runtime_error if the file does not exist, is not a regular file or cannot be read
std::uint64_t ReadableFileSize(const std::string& path);

}

#endif
