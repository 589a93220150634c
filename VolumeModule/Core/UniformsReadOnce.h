#ifndef Varimarch_Core_UniformsReadOnce_h
#define Varimarch_Core_UniformsReadOnce_h

#include "Core/ShaderAssembly.h"

namespace varimarch
{

/// The files of a fragment shader, changed so that each uniform number, vector or matrix is read
/// once, where RayMarch.frag.glsl says so, and a variable stands wherever it is used. For llvmpipe,
/// which gathers a uniform anew for every pixel of its vectors, in loops too, wherever it is named
/// (Documentation/Decisions/0017). Lines keep their numbers. Shaders of several volumes are left
/// as they are, and those without that place.
/// @param unity  Unity.glsl, which then stands behind the first file
std::vector<ShaderFile> WithUniformsReadOnce(
  std::vector<ShaderFile> files, const ShaderFile& unity);

}

#endif
