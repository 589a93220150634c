#ifndef Varimarch_Core_Recipe_FlatParameters_h
#define Varimarch_Core_Recipe_FlatParameters_h

#include "Core/Recipe/ShaderAssembly.h"

namespace varimarch
{

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
