#ifndef Varimarch_Core_Parameters_MarchParameters_h
#define Varimarch_Core_Parameters_MarchParameters_h

#include "Core/Parameters/ShaderTypes.h"

// Two GLSL files are the structs RayParameters and VolumeParameters: the numbers that a march
// reads, computed once, read by the processor as they are and uploaded for shaders. The
// preprocessor turns "layout(std140) uniform" into "struct".
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
