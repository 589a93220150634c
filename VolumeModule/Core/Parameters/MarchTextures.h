#ifndef Varimarch_Core_Parameters_MarchTextures_h
#define Varimarch_Core_Parameters_MarchTextures_h

#include <glm/vec4.hpp>

#include <cstddef>

class vtkTextureObject;

namespace varimarch
{

/// A texture of a march, where each marcher reads it: shaders on the device, packets of rays in
/// memory. Owned by others.
struct MarchTexture
{
  vtkTextureObject* onDevice = nullptr; ///< A handle that Core only passes on.
  const void* inMemory = nullptr;       ///< Null if packets have nothing to read.

  explicit operator bool() const { return this->inMemory != nullptr; }

  /// The texels in memory.
  template <class Texel>
  const Texel* Texels() const
  {
    return static_cast<const Texel*>(this->inMemory);
  }

  /// An entry of a table in memory.
  const glm::vec4& operator[](std::ptrdiff_t entry) const
  {
    return this->Texels<glm::vec4>()[entry];
  }
};

}

// The structs RayTextures and VolumeTextures are made from two GLSL files, with a member for each
// sampler.
#define uniform

namespace varimarch::shader
{

using sampler2D = MarchTexture;
using sampler3D = MarchTexture;
using samplerBuffer = MarchTexture;

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
