#ifndef Varimarch_PictureResources_h
#define Varimarch_PictureResources_h

#include "BlueNoiseTexture.h"
#include "FloatFramebuffer.h"

#include <vector>

namespace varimarch
{

/// What a picture takes beside its volume, each only where it is asked for.
struct PictureResources
{
  FloatFramebuffer rays;  ///< where they are not as many as pixels
  BlueNoiseTexture noise; ///< with jitter

  std::size_t Bytes() const { return this->rays.Bytes() + this->noise.Bytes(); }

  std::vector<vtkTextureObject*> Textures() const
  {
    return { this->rays.Texture(), this->noise.Texture() };
  }

  void Release(vtkWindow* window)
  {
    this->rays.Release(window);
    this->noise.Release(window);
  }
};

}

#endif
