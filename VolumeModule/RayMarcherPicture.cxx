// How the volume becomes the picture: with a ray in each pixel, or with fewer or more of them,
// which are drawn in a framebuffer of their own.

#include "RayMarcher.h"

#include "vtkOpenGLRenderWindow.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

// Rays of a picture whose pixels are as far apart as that [pixels]; more than one in a pixel stand
// in equal rows.
Viewport RaysOf(const Viewport& picture, double imageSampleDistance)
{
  if (imageSampleDistance < 1.0)
  {
    const int perSide = int(std::lround(1.0 / imageSampleDistance));
    return { 0, 0, picture.width * perSide, picture.height * perSide };
  }
  const auto side = [&](int pixels)
  { return std::max(int(std::lround(pixels / imageSampleDistance)), 1); };
  return { 0, 0, side(picture.width), side(picture.height) };
}

}

void RayMarcher::DrawPicture(const Frame& frame)
{
  const Viewport rays = RaysOf(frame.viewport, frame.imageSampleDistance);
  this->usedImageSampleDistance = double(frame.viewport.width) / rays.width;
  if (frame.settings.pass != RayPass::Whole)
  {
    this->DrawPass(frame);
    return;
  }
  if (frame.toImages)
  {
    this->DrawImages(frame, rays);
    return;
  }
  this->picture.ReleaseImages(frame.window);
  if (rays.width == frame.viewport.width && rays.height == frame.viewport.height)
  {
    this->picture.rays.Release(frame.window);
    this->DrawVolume(frame);
    return;
  }
  Frame coarse = frame;
  coarse.viewport = rays;
  this->picture.rays.Draw(frame.window, rays, [&] { this->DrawVolume(coarse); });

  Frame picture = frame;
  picture.settings.pass = rays.width > frame.viewport.width ? RayPass::Averaged : RayPass::Upscaled;
  this->UpdateProgram(picture);
  this->DrawBox(picture, this->BoxOfVisible());
}

void RayMarcher::SetResampledUniforms(const Frame& frame)
{
  const Viewport rays = RaysOf(frame.viewport, frame.imageSampleDistance);
  this->picture.rays.Texture()->Activate();
  this->program.Set("coarseTexture", this->picture.rays.Texture());
  if (frame.settings.pass == RayPass::Averaged)
  {
    this->program.Set("raysPerSide", rays.width / frame.viewport.width);
    return;
  }
  this->program.Set("lastCoarsePixel", glm::ivec2(rays.width, rays.height) - 1);
  this->program.Set("coarsePerPixel",
    glm::dvec2(rays.width, rays.height) / glm::dvec2(frame.viewport.width, frame.viewport.height));
  if (frame.settings.sceneGeometry)
  {
    this->program.Set("sameSurfaceMm", frame.geometry.SmallestSpacingMm());
  }
}

}
