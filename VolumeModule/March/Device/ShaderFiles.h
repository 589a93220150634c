#ifndef Varimarch_March_Device_ShaderFiles_h
#define Varimarch_March_Device_ShaderFiles_h

#include "Core/Recipe/ShaderAssembly.h"

#include "VarimarchVolumeModule.h"

#include <string>
#include <vector>

namespace varimarch
{

/// A shader file that is compiled into the library.
struct ShaderTableRow
{
  const char* path; ///< The path below VolumeModule/Shaders.
  const char* text;
};

/// All shader files. Shaders/MakeTable.cmake writes the source of this function during the build.
const std::vector<ShaderTableRow>& ShaderTable();

/// The texts of shader files that are compiled into the library.
/// @param paths  paths below VolumeModule/Shaders
/// @throws std::runtime_error if a path is not part of the build
VARIMARCHVOLUME_EXPORT std::vector<ShaderFile> LoadShaderFiles(
  const std::vector<std::string>& paths);

}

#endif
