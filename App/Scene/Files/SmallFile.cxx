#include "Scene/Files/SmallFile.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace varimarch
{

namespace
{

[[noreturn]] void Fail(const std::string& path, const std::string& reason)
{
  throw std::runtime_error(path + ": cannot be read: " + reason);
}

}

std::string BytesOfSmallFile(const std::string& path)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
  {
    Fail(
      path, std::filesystem::is_directory(status) ? "it is a folder" : "it is a device or a pipe");
  }
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
  {
    Fail(path, std::strerror(errno));
  }
  if (std::filesystem::file_size(path, error) > MostBytesOfSmallFile && !error)
  {
    Fail(path, "it is larger than 16 MB, and so neither a scene nor a look");
  }
  std::string bytes(std::istreambuf_iterator<char>(stream), {});
  if (stream.bad())
  {
    Fail(path, "reading stopped after " + std::to_string(bytes.size()) + " bytes");
  }
  return bytes;
}

}
