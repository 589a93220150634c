#ifndef Varimarch_Core_Recipe_FlatUniforms_h
#define Varimarch_Core_Recipe_FlatUniforms_h

#include "Core/Recipe/ShaderAssembly.h"

namespace varimarch
{

/// Changes a shader so that the numbers, vectors and matrices that are uniforms of its fragment
/// shader are read by the vertex shader, which hands them on as flat variables; where
/// RayMarch.vert.glsl says so. For llvmpipe, which gathers a uniform anew for every pixel of its
/// vectors, in loops too, wherever it is named (Documentation/Decisions/0017). Lines keep their
/// numbers. Shaders of several volumes are left as they are, and so are uniforms for which there
/// are not enough variables.
/// @param mostComponents  numbers that a vertex shader can hand on, >= 0
void HandUniformsOn(
  std::vector<ShaderFile>& vertex, std::vector<ShaderFile>& fragment, int mostComponents);

}

#endif
