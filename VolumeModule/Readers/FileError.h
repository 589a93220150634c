#ifndef Varimarch_Readers_FileError_h
#define Varimarch_Readers_FileError_h

#include <cstdint>
#include <string>

namespace varimarch
{

/// Throws the one sentence that every reader speaks:
/// Cannot read "path": expected <expected>, found <found>.
/// @throws std::runtime_error always
[[noreturn]] void FailToRead(
  const std::string& path, const std::string& expected, const std::string& found);

/// A piece of a file for use in a sentence: cut at 40 characters, unprintable ones as '?', quoted.
std::string Quoted(const std::string& text);

/// Size of a file that exists and can be read [bytes].
/// @throws std::runtime_error when it is missing, not a file, or not readable
std::uint64_t ReadableFileSize(const std::string& path);

}

#endif
