#include "March/PassMarch.h"

#include "March/RayParametersBuilder.h"

#include "vtkOpenGLRenderWindow.h"

#include <stdexcept>

namespace varimarch
{

void PassMarch::Draw(const Frame& frame, const MarchPlan& plan, FrameMarcher& marcher)
{
  if (this->resources.IsInBlocks())
  {
    throw std::runtime_error("A volume in blocks cannot be drawn between translucent geometry or "
                             "selected: the maximum graphics memory, or the device's 3D textures, "
                             "are too small for it");
  }
  marcher.Draw(frame, plan);
}

void PassMarch::DrawImages(const Frame& frame, const MarchPlan& plan, FrameMarcher& marcher)
{
  const Viewport rays = RaysOf(plan.viewport, plan.imageSampleDistance);
  const MarchPlan images = plan.WithPass(RayPass::PictureAndDepth).WithViewport(rays);
  this->images.Draw(frame.view.window, rays, [&] { this->Draw(frame, images, marcher); });
  this->imagePixels = rays;
}

std::vector<float> PassMarch::ColorImage(vtkOpenGLRenderWindow* window)
{
  return this->images.Read(window, this->imagePixels, 0);
}

std::vector<float> PassMarch::DepthImage(vtkOpenGLRenderWindow* window)
{
  return this->images.Read(window, this->imagePixels, 1);
}

void PassMarch::Release(vtkWindow* window)
{
  this->images.Release(window);
  this->imagePixels = {};
}

}
