#include "March/Device/ShaderFiles.h"

#include <algorithm>
#include <stdexcept>

namespace varimarch
{

std::vector<ShaderFile> LoadShaderFiles(const std::vector<std::string>& paths)
{
  const std::vector<ShaderTableRow>& table = ShaderTable();
  std::vector<ShaderFile> files;
  for (const std::string& path : paths)
  {
    const auto found = std::find_if(
      table.begin(), table.end(), [&](const ShaderTableRow& row) { return path == row.path; });
    if (found == table.end())
    {
      throw std::runtime_error("Shader file " + path + " is not part of this build");
    }
    files.push_back({ path, found->text });
  }
  return files;
}

}
