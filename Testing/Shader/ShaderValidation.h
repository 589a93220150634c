#ifndef Varimarch_Testing_ShaderValidation_h
#define Varimarch_Testing_ShaderValidation_h

#include "Core/Recipe/ShaderAssembly.h"

#include <string>
#include <vector>

namespace varimarch
{

/// The files of a shader and those that they include.
/// @param paths  below VolumeModule/Shaders
/// @throws std::logic_error if there is no such file
std::vector<ShaderFile> LoadParts(const std::vector<std::string>& paths);

/// The files of a shader, and its stage: "vert" or "frag".
struct StagedShader
{
  std::vector<ShaderFile> files;
  std::string stage;
};

struct ShaderValidation
{
  bool passed;
  std::string messages; ///< the compiler's, traced to the files
};

/// Compiles a shader with the reference compiler for GLSL, without OpenGL.
ShaderValidation Validate(const StagedShader& shader);

/// Compiles many shaders in one run of that compiler, which takes a tenth of the time.
/// @return for each that fails its files and the messages; empty: all compile
std::vector<std::string> FaultsOf(const std::vector<StagedShader>& shaders);

}

#endif
