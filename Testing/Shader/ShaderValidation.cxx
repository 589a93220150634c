#include "ShaderValidation.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <sys/wait.h>
#include <unistd.h>

namespace varimarch
{

namespace
{

std::string TextOf(const std::string& path)
{
  std::ifstream stream(std::string(SHADER_FOLDER) + "/" + path);
  if (!stream)
  {
    throw std::logic_error("there is no shader file " + path);
  }
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}

std::vector<ShaderFile> LoadParts(const std::vector<std::string>& paths)
{
  std::vector<ShaderFile> files;
  for (const std::string& path : paths)
  {
    files.push_back({ path, TextOf(path) });
  }
  return WithIncludes(files, TextOf);
}

ShaderValidation Validate(const std::vector<ShaderFile>& files, const std::string& stage)
{
  // Tests run concurrently in separate processes, so each needs its own file.
  const std::string path =
    std::string(SCRATCH_FOLDER) + "/recipe-" + std::to_string(getpid()) + "." + stage;
  std::ofstream(path) << AssembleShader(files);
  const std::string command = std::string(GLSLANG_VALIDATOR) + " '" + path + "' 2>&1";
  FILE* const pipe = popen(command.c_str(), "r");
  std::string messages;
  std::array<char, 256> line;
  while (std::fgets(line.data(), int(line.size()), pipe))
  {
    messages += line.data();
  }
  const int status = pclose(pipe);
  std::remove(path.c_str());
  return { WIFEXITED(status) && WEXITSTATUS(status) == 0, TraceShaderErrors(messages, files) };
}

}
