#ifndef Varimarch_ShaderFiles_h
#define Varimarch_ShaderFiles_h

#include "Core/ShaderAssembly.h"

#include <string>
#include <vector>

namespace varimarch
{

/// The text of shader files that are compiled into the library.
/// @param paths  below VolumeModule/Shaders
/// @throws std::runtime_error naming a path that is not in the build's list
std::vector<ShaderFile> LoadShaderFiles(const std::vector<std::string>& paths);

}

#endif
