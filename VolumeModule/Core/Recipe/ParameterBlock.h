#ifndef Varimarch_Core_Recipe_ParameterBlock_h
#define Varimarch_Core_Recipe_ParameterBlock_h

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

}

#endif
