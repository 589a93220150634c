// How the volume becomes the picture: with a ray in each pixel, or with fewer or more of them,
// which are drawn in a framebuffer of their own.

#include "March/RayMarcher.h"

#include "March/RayParametersBuilder.h"

#include "vtkOpenGLRenderWindow.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

// Of a picture after the first of the same scene, beside the first's.
constexpr double LaterTolerance = 1.0 / 4.0;
constexpr double LaterDistance = 1.0 / 2.0;

// Between the rays of what is seen until the first picture is there: a sixteenth of its time.
constexpr double DistanceBeneath = 4.0; // [pixels]

}

// The first picture is what it would be alone. The next ones have shorter steps.
void RayMarcher::BeginAccumulation(Frame& frame)
{
  if (frame.settings.pass != RayPass::Whole)
  {
    return;
  }
  const bool accumulates = frame.mostAccumulated > 0 && frame.others.empty() && !frame.toImages &&
    !frame.settings.countFetches && frame.imageSampleDistance == 1.0;
  if (!accumulates)
  {
    frame.mostAccumulated = 0;
    this->picture.accumulated.Release(frame.window);
    return;
  }
  this->picture.accumulated.Begin(frame.sceneNumbers);
  if (this->picture.accumulated.Count() > 0)
  {
    frame.errorTolerance *= LaterTolerance;
    frame.sampleDistanceMm *= LaterDistance;
  }
}

void RayMarcher::DrawAccumulated(const Frame& frame)
{
  varimarch::AccumulatedPictures& pictures = this->picture.accumulated;
  if (pictures.Count() < frame.mostAccumulated)
  {
    Frame next = frame;
    next.viewport = { 0, 0, frame.viewport.width, frame.viewport.height };
    next.rayOffsetPixels = pictures.NextOffsetPixels();
    next.addsUp = true;
    // Blocks are drawn into a framebuffer of all the rays.
    const bool isInStrips =
      frame.longestPartSeconds > 0.0 && this->volume.Blocks().Partition().Count() == 1;
    if (isInStrips && pictures.IsEmpty() && pictures.IsDivided(next.viewport))
    {
      this->DrawBeneath(frame);
    }
    pictures.Add(frame.window, next.viewport, isInStrips ? frame.longestPartSeconds : 0.0,
      [&] { this->DrawVolume(next); });
  }
  Frame mean = frame;
  mean.settings.pass = RayPass::Accumulated;
  this->UpdateProgram(mean);
  DrawnBlock drawn = this->BoxOfVisible();
  drawn.coverGrid = WithItsEdges(drawn.coverGrid);
  this->DrawBox(mean, drawn);
}

// What is seen where the first picture has not come yet.
void RayMarcher::DrawBeneath(const Frame& frame)
{
  Frame beneath = frame;
  beneath.viewport = { 0, 0, frame.viewport.width, frame.viewport.height };
  beneath.imageSampleDistance = DistanceBeneath;
  this->picture.accumulated.Begin(
    frame.window, beneath.viewport, [&] { this->DrawResampled(beneath); });
  this->picture.rays.Release(frame.window);
}

int RayMarcher::AccumulatedPictures() const
{
  return this->picture.accumulated.IsEmpty() ? 1 : this->picture.accumulated.Count();
}

double RayMarcher::DrawnPart(int mostAccumulated) const
{
  const varimarch::AccumulatedPictures& pictures = this->picture.accumulated;
  return pictures.IsEmpty() ? 1.0 : std::min(pictures.CountWithParts() / mostAccumulated, 1.0);
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
  this->picture.layerDepths.Release(frame.window);
  if (frame.toImages)
  {
    this->DrawImages(frame, rays);
    return;
  }
  this->picture.ReleaseImages(frame.window);
  if (frame.mostAccumulated > 0)
  {
    this->picture.rays.Release(frame.window);
    this->DrawAccumulated(frame);
    return;
  }
  if (rays.width == frame.viewport.width && rays.height == frame.viewport.height)
  {
    this->picture.rays.Release(frame.window);
    this->DrawVolume(frame);
    return;
  }
  this->DrawResampled(frame);
}

void RayMarcher::DrawResampled(const Frame& frame)
{
  const Viewport rays = RaysOf(frame.viewport, frame.imageSampleDistance);
  Frame coarse = frame;
  coarse.viewport = rays;
  this->picture.rays.Draw(frame.window, rays, [&] { this->DrawVolume(coarse); });

  Frame picture = frame;
  picture.settings.pass = rays.width > frame.viewport.width ? RayPass::Averaged : RayPass::Upscaled;
  this->UpdateProgram(picture);
  this->DrawBox(picture, this->BoxOfVisible());
}

}
