#ifndef Varimarch_Core_Recipe_ShaderAssembly_h
#define Varimarch_Core_Recipe_ShaderAssembly_h

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace varimarch
{

/// A member of a uniform block.
struct BlockMember
{
  std::string type;
  std::string name;
  int count; ///< The length of an array; 1 for a single value.
};

/// The members of the uniform block in the text of a shader file such as RayParameters.glsl, which
/// has one per line; empty if the file declares no block.
std::vector<BlockMember> MembersOf(const std::string& text);

/// The number of components of a member.
int ComponentsOf(const BlockMember& member);

/// The names of the samplers in the text of a shader file such as RayTextures.glsl, in its order.
std::vector<std::string> SamplersOf(const std::string& text);

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

/// Changes a shader so that the vertex shader reads the parameters that the fragment shader uses,
/// and passes them on as flat variables. This is for llvmpipe, which gathers a uniform for every
/// pixel of its vectors each time it is used, even in loops (Documentation/Decisions/0017). Members
/// of the blocks are passed in their order while there are variables left; the fragment shader
/// reads the others from the blocks. Shaders of several volumes are not changed.
/// @param mostComponents  numbers that a vertex shader can pass on, >= 0
void HandParametersOn(
  std::vector<ShaderFile>& vertex, std::vector<ShaderFile>& fragment, int mostComponents);

}

#endif
