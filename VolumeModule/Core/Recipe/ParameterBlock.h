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
  int count; ///< of an array; 1 for one value
};

/// The members of the uniform block that a shader file such as RayParameters.glsl declares, one in
/// a line; none where the file declares no block.
std::vector<BlockMember> MembersOf(const std::string& text);

/// The numbers that a member consists of.
int ComponentsOf(const BlockMember& member);

/// The names of the samplers that a shader file such as RayTextures.glsl declares, in its order.
std::vector<std::string> SamplersOf(const std::string& text);

}

#endif
