#ifndef Varimarch_Core_Recipe_ShaderAssembly_h
#define Varimarch_Core_Recipe_ShaderAssembly_h

#include <cstddef>
#include <string>
#include <vector>

namespace varimarch
{

struct ShaderFile
{
  std::string path; ///< below VolumeModule/Shaders
  std::string text;
};

/// Joins files to one GLSL 1.50 source. Lines are numbered so that a compiler's message can be
/// traced back: line n of the i-th file is line 1000 * (i + 1) + n. Where VolumeParameters.glsl
/// stands several times, what it and the files behind it declare is renamed for all volumes but the
/// last: the preprocessor does it.
std::string AssembleShader(const std::vector<ShaderFile>& files);

/// How many volumes a fragment shader is for: as often as VolumeParameters.glsl is among its files.
std::size_t VolumeCount(const std::vector<ShaderFile>& files);

/// The name that a declaration of one of several volumes gets. The last volume keeps its names.
std::string NameOfVolume(const std::string& name, std::size_t volume);

/// A compiler's messages with its line numbers turned into paths and lines, for the same files:
/// "0:3009(5): error" becomes "Blend/Composite.glsl:9: error".
std::string TraceShaderErrors(const std::string& messages, const std::vector<ShaderFile>& files);

}

#endif
