#ifndef Varimarch_Core_Recipe_FlatParameters_h
#define Varimarch_Core_Recipe_FlatParameters_h

#include "Core/Recipe/ShaderAssembly.h"

namespace varimarch
{

/// Changes a shader so that the vertex shader reads the parameters that the fragment shader names,
/// and hands them on as flat variables. This is for llvmpipe, which gathers a uniform anew for
/// every pixel of its vectors, in loops too, wherever it is named (Documentation/Decisions/0017).
/// Members of the blocks are handed on in their order while there are variables for them; the
/// fragment shader reads the others from the blocks. Shaders of several volumes stay as they are.
/// @param mostComponents  numbers that a vertex shader can hand on, >= 0
void HandParametersOn(
  std::vector<ShaderFile>& vertex, std::vector<ShaderFile>& fragment, int mostComponents);

}

#endif
