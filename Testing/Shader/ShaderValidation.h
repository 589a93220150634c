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

struct ShaderValidation
{
  bool passed;
  std::string messages; ///< the compiler's, traced to the files
};

/// Compiles a shader with the reference compiler for GLSL, without OpenGL.
/// @param stage  "vert" or "frag"
ShaderValidation Validate(const std::vector<ShaderFile>& files, const std::string& stage);

}

#endif
