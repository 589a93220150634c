#ifndef Varimarch_Core_ShaderAssembly_h
#define Varimarch_Core_ShaderAssembly_h

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
/// traced back: line n of the i-th file is line 1000 * (i + 1) + n.
std::string AssembleShader(const std::vector<ShaderFile>& files);

/// A compiler's messages with its line numbers turned into paths and lines, for the same files:
/// "0:3009(5): error" becomes "Blend/Composite.glsl:9: error".
std::string TraceShaderErrors(const std::string& messages, const std::vector<ShaderFile>& files);

}

#endif
