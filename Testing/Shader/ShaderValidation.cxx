#include "ShaderValidation.h"

#include <array>
#include <cstdio>
#include <filesystem>
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

// Tests run concurrently in separate processes, so each needs its own files.
std::string ScratchName()
{
  return std::string(SCRATCH_FOLDER) + "/recipe-" + std::to_string(getpid());
}

ShaderValidation Run(const std::string& command)
{
  FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
  std::string messages;
  std::array<char, 256> line;
  while (std::fgets(line.data(), int(line.size()), pipe))
  {
    messages += line.data();
  }
  const int status = pclose(pipe);
  return { WIFEXITED(status) && WEXITSTATUS(status) == 0, messages };
}

std::string PathsOf(const std::vector<ShaderFile>& files)
{
  std::string text;
  for (const ShaderFile& file : files)
  {
    text += file.path + " ";
  }
  return text;
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

ShaderValidation Validate(const StagedShader& shader)
{
  const std::string path = ScratchName() + "." + shader.stage;
  std::ofstream(path) << AssembleShader(shader.files);
  const ShaderValidation validation = Run(std::string(GLSLANG_VALIDATOR) + " '" + path + "'");
  std::filesystem::remove(path);
  return { validation.passed, TraceShaderErrors(validation.messages, shader.files) };
}

std::vector<std::string> FaultsOf(const std::vector<StagedShader>& shaders)
{
  const std::string folder = ScratchName();
  std::filesystem::create_directories(folder);
  for (std::size_t i = 0; i < shaders.size(); ++i)
  {
    std::ofstream(folder + "/" + std::to_string(i) + "." + shaders[i].stage)
      << AssembleShader(shaders[i].files);
  }
  const ShaderValidation all = Run("cd '" + folder + "' && " + GLSLANG_VALIDATOR + " *");
  std::filesystem::remove_all(folder);
  std::vector<std::string> faults;
  for (std::size_t i = 0; i < shaders.size() && !all.passed; ++i)
  {
    const ShaderValidation one = Validate(shaders[i]);
    if (!one.passed)
    {
      faults.push_back(PathsOf(shaders[i].files) + "\n" + one.messages);
    }
  }
  if (!all.passed && faults.empty())
  {
    faults.push_back(all.messages);
  }
  return faults;
}

}
