#ifndef Varimarch_March_Device_MarchTextures_h
#define Varimarch_March_Device_MarchTextures_h

class vtkTextureObject;

// Two GLSL files are the structs RayTextures and VolumeTextures: a pointer for each of their
// samplers, null where a scene has no such texture.
#define uniform

namespace varimarch::shader
{

using sampler2D = vtkTextureObject*;
using sampler3D = vtkTextureObject*;
using samplerBuffer = vtkTextureObject*;

struct RayTextures
{
#include "Shaders/RayTextures.glsl"
};

struct VolumeTextures
{
#include "Shaders/VolumeTextures.glsl"
};

}

#undef uniform

namespace varimarch
{

using shader::RayTextures;
using shader::VolumeTextures;

}

#endif
