#ifndef Varimarch_March_Device_ShaderFiles_h
#define Varimarch_March_Device_ShaderFiles_h

#include "Core/Recipe/ShaderAssembly.h"

#include <string>
#include <vector>

namespace varimarch
{

/// A shader file that is compiled into the library.
struct ShaderTableRow
{
  const char* path; ///< below VolumeModule/Shaders
  const char* text;
};

/// All of them. Shaders/MakeTable.cmake writes its source file while building.
const std::vector<ShaderTableRow>& ShaderTable();

/// The text of shader files that are compiled into the library.
/// @param paths  below VolumeModule/Shaders
/// @throws std::runtime_error naming a path that is not a file of the build
std::vector<ShaderFile> LoadShaderFiles(const std::vector<std::string>& paths);

}

#endif
