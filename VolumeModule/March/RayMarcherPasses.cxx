// What is drawn in the picture's place: translucent geometry's layers of it, selections, images.

#include "March/RayMarcher.h"

#include "vtkOpenGLRenderWindow.h"

#include <stdexcept>

namespace varimarch
{

void RayMarcher::DrawPass(const Frame& frame)
{
  if (this->volume.Blocks().Partition().Count() > 1)
  {
    throw std::runtime_error("A volume in blocks is not drawn between translucent geometry, nor "
                             "selected: the maximum graphics memory, or the device's 3D textures, "
                             "are too small for it");
  }
  this->DrawVolume(frame);
}

void RayMarcher::DrawImages(const Frame& frame, const Viewport& rays)
{
  Frame images = frame;
  images.viewport = rays;
  images.settings.pass = RayPass::PictureAndDepth;
  this->picture.images.Draw(frame.window, rays, [&] { this->DrawPass(images); });
  this->picture.imagePixels = rays;
}

std::vector<float> RayMarcher::ColorImage()
{
  return this->picture.images.Read(this->window, this->picture.imagePixels, 0);
}

std::vector<float> RayMarcher::DepthImage()
{
  return this->picture.images.Read(this->window, this->picture.imagePixels, 1);
}

}
