#ifndef Varimarch_Core_Parameters_MarchParameters_h
#define Varimarch_Core_Parameters_MarchParameters_h

#include "Core/Parameters/ShaderTypes.h"

// The structs RayParameters and VolumeParameters are made from two GLSL files. They hold the
// numbers that a march reads; the processor reads them directly, and shaders from an uploaded copy.
// The preprocessor turns "layout(std140) uniform" into "struct".
#define layout(packing)
#define uniform struct

namespace varimarch::shader
{

#include "Shaders/RayParameters.glsl"
#include "Shaders/VolumeParameters.glsl"

}

#undef uniform
#undef layout

namespace varimarch
{

using shader::RayParameters;
using shader::VolumeParameters;

}

#endif
