#include "OutputFolder.h"

#include "Messages.h"
#include "Scene/Files/OutputFile.h"

#include <stdexcept>

namespace varimarch
{

std::filesystem::path OutputFolder(const std::string& path)
{
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (!std::filesystem::is_directory(path))
  {
    throw std::runtime_error(path + ": expected a folder to write to, or a name for a new one" +
      (error ? ": " + error.message() : ""));
  }
  return path;
}

void SetInterruptNotice(const std::filesystem::path& folder, const std::string& contents)
{
  SetInterruptNotice(ProgramName() + ": stopped; " + folder.string() + " holds " + contents);
}

}
