#include "March/ImageAccumulator.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>

namespace varimarch
{

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
