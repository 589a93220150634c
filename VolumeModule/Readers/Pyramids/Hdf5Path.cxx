#include "Readers/Pyramids/Hdf5Path.h"

#include <filesystem>

namespace varimarch
{

Hdf5Path Hdf5PathOf(const std::string& path)
{
  namespace fs = std::filesystem;
  std::error_code unknown;
  for (std::size_t end = path.find('/', 1); end != std::string::npos; end = path.find('/', end + 1))
  {
    const std::string file = path.substr(0, end);
    const bool isFile = fs::is_regular_file(file, unknown);
    if (isFile && end + 1 < path.size())
    {
      return { file, path.substr(end) };
    }
  }
  return { path, "" };
}

}
