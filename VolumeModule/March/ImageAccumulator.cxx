#include "March/ImageAccumulator.h"

#include "VtkVersions.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <glm/common.hpp>

#include <algorithm>
#include <chrono>

namespace varimarch
{

void ImageSum::Begin(const Fingerprint& newScene)
{
  if (this->scene != newScene)
  {
    this->scene = newScene;
    this->count = 0;
    this->strips.Restart();
  }
}

// The R2 sequence of M. Roberts, "The unreasonable effectiveness of quasirandom sequences" (2018),
// based on the plastic number: any number of successive offsets is spread evenly.
glm::dvec2 ImageSum::NextOffsetPixels() const
{
  const glm::dvec2 step(0.7548776662466927, 0.5698402909980532);
  return glm::fract(0.5 + double(this->count) * step) - 0.5;
}

void ImageSum::Begin(
  vtkOpenGLRenderWindow* window, const Viewport& pixels, const std::function<void()>& draw)
{
  this->sum.Draw(window, pixels, draw);
}

void ImageSum::Add(vtkOpenGLRenderWindow* window, const Viewport& pixels, double longestSeconds,
  const std::function<void()>& draw)
{
  this->imageRows = pixels.height;
  const PictureStrips::Rows strip = this->strips.Next(pixels.height, longestSeconds);
  if (longestSeconds > 0.0)
  {
    window->WaitForCompletion();
  }
  const auto begin = std::chrono::steady_clock::now();
  this->sum.DrawMore(window, pixels,
    [&]
    {
      vtkOpenGLState* const state = window->GetState();
      const vtkOpenGLState::ScopedglScissor scissor(state);
      state->vtkglEnable(GL_SCISSOR_TEST);
      state->vtkglScissor(0, strip.begin, pixels.width, strip.count);
      if (this->count == 0)
      {
        const vtkOpenGLState::ScopedglClearColor clearColor(state);
        state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
        state->vtkglClear(GL_COLOR_BUFFER_BIT);
      }
      draw();
    });
  if (longestSeconds > 0.0)
  {
    window->WaitForCompletion();
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  this->strips.Took(strip, took.count(), longestSeconds);
  if (this->RowsOfNext() == pixels.height)
  {
    ++this->count;
    this->strips.Restart();
  }
}

void ImageSum::Release(vtkWindow* window)
{
  this->sum.Release(window);
  this->count = 0;
  this->strips.Restart();
}

void ImageAccumulator::Begin(const Frame& frame, MarchPlan& plan)
{
  if (plan.pass != RayPass::Whole)
  {
    return;
  }
  const bool accumulates = plan.mostAccumulated > 0 && frame.others.empty() &&
    !frame.image.toImages && !frame.settings.countFetches && plan.imageSampleDistance == 1.0;
  if (!accumulates)
  {
    plan.mostAccumulated = 0;
    this->sum.Release(frame.view.window);
    return;
  }
  this->sum.Begin(frame.accumulation.fingerprint);
  if (this->sum.Count() > 0)
  {
    plan.budget = plan.budget.WithStepFactor(ErrorBudget::LaterImages);
    plan.sampleDistanceMm *= ErrorBudget::LaterDistance;
  }
}

void ImageAccumulator::Draw(const Frame& frame, const MarchPlan& plan, FrameMarcher& marcher)
{
  if (this->sum.Count() < plan.mostAccumulated)
  {
    this->AddNext(frame, plan, marcher);
  }
  this->DrawMean(frame, plan);
}

void ImageAccumulator::AddNext(const Frame& frame, const MarchPlan& plan, FrameMarcher& marcher)
{
  MarchPlan next = plan.WithViewport({ 0, 0, plan.viewport.width, plan.viewport.height });
  // Blocks need a framebuffer for the rays of the whole image, so they are not drawn in strips.
  const double longestSeconds =
    this->resources.IsInBlocks() ? 0.0 : frame.accumulation.longestPartSeconds;
  if (longestSeconds > 0.0 && this->sum.IsEmpty() && this->sum.IsDivided(next.viewport))
  {
    this->DrawBeneath(frame, next, marcher);
  }
  next.rayOffsetPixels = this->sum.NextOffsetPixels();
  next.addsUp = true;
  this->sum.Add(
    frame.view.window, next.viewport, longestSeconds, [&] { marcher.Draw(frame, next); });
}

// Draws a coarse image, visible until the strips of the first image cover it.
void ImageAccumulator::DrawBeneath(const Frame& frame, MarchPlan plan, FrameMarcher& marcher)
{
  plan.imageSampleDistance = 4.0; // a sixteenth of the rays
  this->sum.Begin(
    frame.view.window, plan.viewport, [&] { this->resampled.Draw(frame, plan, marcher); });
  this->resampled.Release(frame.view.window);
}

void ImageAccumulator::DrawMean(const Frame& frame, const MarchPlan& plan)
{
  DrawnBlock drawn = AllThatIsVisible(this->resources.DrawnBox());
  drawn.coverGrid = WithItsEdges(drawn.coverGrid);
  EarlierDrawings earlier;
  earlier.sum = this->sum.Texture();
  earlier.imageCount = this->sum.Count();
  earlier.rowsOfNext = this->sum.RowsOfNext();
  this->boxes.Draw(frame, plan.WithPass(RayPass::Accumulated), drawn, earlier);
}

double ImageAccumulator::DrawnPart(int mostImages) const
{
  return this->sum.IsEmpty() ? 1.0 : std::min(this->sum.CountWithParts() / mostImages, 1.0);
}

}
