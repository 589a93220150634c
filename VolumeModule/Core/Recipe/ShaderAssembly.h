#ifndef Varimarch_Core_Recipe_ShaderAssembly_h
#define Varimarch_Core_Recipe_ShaderAssembly_h

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace varimarch
{

struct ShaderFile
{
  std::string path; ///< below VolumeModule/Shaders
  std::string text;
};

/// Puts the files that are included by others in front of all, each of them once, in the order in
/// which they are included. A line `#include "PATH"` becomes an empty line. Included files include
/// no others.
/// @param read  (path) -> text of a file
std::vector<ShaderFile> WithIncludes(const std::vector<ShaderFile>& files,
  const std::function<std::string(const std::string& path)>& read);

/// Joins files into one GLSL 1.50 source. Line n of the i-th file gets the number 1000 * (i + 1) +
/// n, so that compiler messages can be traced to files. If VolumeParameters.glsl occurs several
/// times, the preprocessor renames everything that it and the files after it declare, for all
/// volumes but the last.
std::string AssembleShader(const std::vector<ShaderFile>& files);

/// Number of volumes of a fragment shader: the number of times VolumeParameters.glsl is among its
/// files.
std::size_t VolumeCount(const std::vector<ShaderFile>& files);

/// The name that a declaration gets for one of several volumes other than
/// the last, which keeps its names.
std::string NameOfVolume(const std::string& name, std::size_t volume);

/// Replaces line numbers in compiler messages about the joined source by paths and lines of its
/// files: "0:3009(5): error" becomes "Blend/Composite.glsl:9: error".
std::string TraceShaderErrors(const std::string& messages, const std::vector<ShaderFile>& files);

}

#endif
