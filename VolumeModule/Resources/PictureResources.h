#ifndef Varimarch_Resources_PictureResources_h
#define Varimarch_Resources_PictureResources_h

#include "March/AccumulatedPictures.h"
#include "Resources/BlueNoiseTexture.h"
#include "Resources/FloatFramebuffer.h"

#include <vector>

namespace varimarch
{

/// What a picture takes beside its volume, each only where it is asked for.
struct PictureResources
{
  AccumulatedPictures accumulated; ///< where several pictures are gathered
  FloatFramebuffer rays;           ///< where they are not as many as pixels
  BlueNoiseTexture noise;          ///< with jitter
  FloatFramebuffer layerDepths;    ///< of translucent geometry, where the processor marches
  FloatFramebuffer images{ 2 };    ///< colour, and 1 - depth as red
  Viewport imagePixels = {};       ///< of both; 0: there are none

  std::size_t Bytes() const
  {
    return this->accumulated.Bytes() + this->rays.Bytes() + this->noise.Bytes() +
      this->layerDepths.Bytes() + this->images.Bytes();
  }

  std::vector<vtkTextureObject*> Textures() const
  {
    return { this->accumulated.Sum(), this->rays.Texture(), this->noise.Texture() };
  }

  void Release(vtkWindow* window)
  {
    this->accumulated.Release(window);
    this->rays.Release(window);
    this->noise.Release(window);
    this->layerDepths.Release(window);
    this->ReleaseImages(window);
  }

  void ReleaseImages(vtkWindow* window)
  {
    this->images.Release(window);
    this->imagePixels = {};
  }
};

}

#endif
