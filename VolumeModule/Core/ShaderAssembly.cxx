#include "Core/ShaderAssembly.h"

#include <regex>

namespace varimarch
{

namespace
{
constexpr std::size_t LinesPerFile = 1000;
}

std::string AssembleShader(const std::vector<ShaderFile>& files)
{
  std::string source = "#version 150\n";
  std::size_t index = 0;
  for (const ShaderFile& file : files)
  {
    // In version 1.50 #line numbers the line it stands on; the file's first line comes next.
    ++index;
    source += "#line " + std::to_string(LinesPerFile * index) + "\n";
    source += file.text;
    source += "\n";
  }
  return source;
}

std::string TraceShaderErrors(const std::string& messages, const std::vector<ShaderFile>& files)
{
  // Mesa and glslang write 0:line or 0:line(column), NVIDIA 0(line).
  static const std::regex position(R"(\b0(?::(\d+)(?:\(\d+\))?|\((\d+)\)))");
  std::string traced;
  auto end = messages.begin();
  for (std::sregex_iterator match(messages.begin(), messages.end(), position), none; match != none;
       ++match)
  {
    const std::size_t line = std::stoul((*match)[1].matched ? (*match)[1] : (*match)[2]);
    const std::size_t index = line / LinesPerFile;
    traced.append(end, (*match)[0].first);
    end = (*match)[0].second;
    traced += index >= 1 && index <= files.size()
      ? files[index - 1].path + ":" + std::to_string(line % LinesPerFile)
      : match->str();
  }
  return traced.append(end, messages.end());
}

}
