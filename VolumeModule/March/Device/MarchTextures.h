#ifndef Varimarch_March_Device_MarchTextures_h
#define Varimarch_March_Device_MarchTextures_h

class vtkTextureObject;

// The structs RayTextures and VolumeTextures are made from two GLSL files: they have a pointer for
// each sampler, which is null if a scene has no such texture.
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
