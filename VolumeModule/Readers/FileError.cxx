#include "Readers/FileError.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace varimarch
{

void FailToRead(const std::string& path, const std::string& expected, const std::string& found)
{
  std::string sentence =
    "Cannot read \"" + path + "\": expected " + expected + ", found " + found + ".";
  // The name of a file may come from another file, with any bytes.
  std::replace_if(
    sentence.begin(), sentence.end(), [](unsigned char letter) { return letter < ' '; }, '?');
  throw std::runtime_error(sentence);
}

std::string Quoted(const std::string& text, std::size_t longest)
{
  std::string quoted = text.substr(0, longest);
  for (char& character : quoted)
  {
    if (character < ' ' || character > '~' || character == '"')
    {
      character = '?';
    }
  }
  return '"' + quoted + (text.size() > longest ? "..." : "") + '"';
}

std::uint64_t ReadableFileSize(const std::string& path)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
  {
    FailToRead(path, "an existing file", "no file of this name");
  }
  if (!std::filesystem::is_regular_file(status))
  {
    FailToRead(path, "a regular file", "something else");
  }
  if (!std::ifstream(path, std::ios::binary))
  {
    FailToRead(path, "a readable file", std::string("the error \"") + std::strerror(errno) + '"');
  }
  return std::filesystem::file_size(path);
}

}
