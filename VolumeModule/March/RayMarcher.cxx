#include "March/RayMarcher.h"

#include "Frame/FrameMeasures.h"
#include "March/Device/GraphicsDriver.h"
#include "March/FrameMarcher.h"
#include "March/Processor/PacketMarcher.h"
#include "March/Processor/PacketSceneBuilder.h"
#include "March/RayParametersBuilder.h"
#include "March/SkyParameters.h"

#include "vtkDataArray.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace varimarch
{

namespace
{

// The numbers that decide, apart from the look, whether the device can hold volumes that overlap.
Fingerprint MemoryInputsOf(const Frame& frame)
{
  const Viewport& pixels = frame.view.viewport;
  Fingerprint inputs(frame.device.mostMemoryBytes, pixels.width, pixels.height);
  const auto add = [&](const Frame& one)
  {
    inputs.Add(Fingerprint(one.geometry.dimensions, one.voxels.components.size(),
      one.voxels.scalars->GetDataType(), one.settings.mask != Mask::None, one.settings.cubic,
      one.settings.storedGradients));
  };
  add(frame);
  std::for_each(frame.others.begin(), frame.others.end(), add);
  return inputs;
}

}

MarchPlan RayMarcher::Prepare(const Frame& frame, const std::optional<PictureQuality>& quality)
{
  this->EnterWindow(frame.view.window);
  MarchPlan plan = PlanOf(frame, quality);
  this->accumulator.Begin(frame, plan);
  this->UpdateResources(frame, plan);
  return plan;
}

// Whether the device can hold volumes that overlap is known only with everything else that has to
// be in its memory.
void RayMarcher::UpdateResources(const Frame& frame, MarchPlan& plan)
{
  this->resources.UpdateVoxels(frame);
  const MarchPlan begun = plan;
  const Fingerprint memory = MemoryInputsOf(frame);
  this->ChooseMarcher(frame, plan, ShouldMarchByPackets(frame) || this->tooLargeBy == memory);
  this->resources.Update(frame, plan, this->MemoryOfImages());
  if (this->resources.IsTooLarge() && this->tooLargeBy != memory)
  {
    this->tooLargeBy = memory;
    plan = begun;
    this->ChooseMarcher(frame, plan, true);
    this->resources.Update(frame, plan, this->MemoryOfImages());
  }
  this->resources.CheckOverlap(plan);
  if (!this->resources.IsInBlocks())
  {
    this->shaders.ReleaseBlocks(frame.view.window);
  }
}

std::optional<PreparedTrials> RayMarcher::PrepareTrials(const Frame& frame)
{
  const MarchPlan plan = this->Prepare(frame, {});
  if (!(plan.budget.StepTolerance() > 0.0))
  {
    return std::nullopt;
  }
  return PreparedTrials{ plan, FactsOf(MarchOf(frame, plan), this->resources.First()),
    this->ToleranceInputsOf(frame, plan) };
}

std::vector<std::vector<float>> RayMarcher::DrawTrials(
  const Frame& frame, const MarchPlan& plan, const std::vector<TrialImage>& images)
{
  std::vector<MarchPlan> plans;
  for (const TrialImage& image : images)
  {
    plans.push_back(image.PlanOf(plan));
  }
  this->resources.UpdatePreIntegrated(frame, plans.front());
  return this->MarcherOf(plan).DrawTrials(frame, plans);
}

void RayMarcher::Draw(const Frame& frame, const std::optional<PictureQuality>& quality)
{
  MarchPlan plan = this->Prepare(frame, quality);
  this->TakeSteps(frame, plan);
  this->stepFactor = plan.budget.stepFactor;
  this->lacksRays = plan.imageSampleDistance > frame.image.sampleDistance;
  this->usedSampleDistanceMm = plan.sampleDistanceMm;
  this->wantedSampleDistanceMm = frame.quality.sampleDistanceMm;
  this->notes = AccuracyNotesOf(frame, plan, this->resources);
  this->resources.UpdatePreIntegrated(frame, plan);
  this->DrawImage(frame, plan);
}

bool RayMarcher::KeepsTolerance() const
{
  const auto isKept = [&](const std::optional<StepChoice>& step)
  { return !step || this->stepFactor * step->ofLimit <= 1.0; };
  return !this->lacksRays && isKept(this->foundStep) && isKept(this->FoundStepOfLight());
}

bool RayMarcher::HasUnknownError() const
{
  return std::any_of(this->notes.begin(), this->notes.end(),
    [](const AccuracyNote& note) { return note.error != AccuracyNote::Error::Known; });
}

double RayMarcher::EstimatedError() const
{
  const double ofLight = this->FoundStepOfLight() ? this->FoundStepOfLight()->error : 0.0;
  return this->foundStep ? std::max(this->foundStep->error, ofLight) : 0.0;
}

void RayMarcher::CastOnGeometry(
  const Frame& frame, const std::optional<PictureQuality>& quality, ReceivedLight& light)
{
  this->EnterWindow(frame.view.window);
  MarchPlan plan = PlanOf(frame, quality);
  this->UpdateResources(frame, plan);
  this->dimming.TakeLight(frame, plan, light);
}

void RayMarcher::DimGeometry(
  const Frame& frame, const std::optional<PictureQuality>& quality, const ReceivedLight& light)
{
  this->dimming.Draw(frame, PlanOf(frame, quality), light);
}

void RayMarcher::EnterWindow(vtkOpenGLRenderWindow* newWindow)
{
  if (this->window && this->window != newWindow)
  {
    vtkOpenGLRenderWindow* const left = this->window;
    left->PushContext();
    this->Release(left);
    left->PopContext();
  }
  this->window = newWindow;
}

void RayMarcher::ChooseMarcher(const Frame& frame, MarchPlan& plan, bool shouldMarchByPackets)
{
  if (shouldMarchByPackets && CanMarchByPackets(frame, this->resources))
  {
    plan.marcher = Marcher::Processor;
    if (IsMixture(frame))
    {
      plan.integration = Integration::Midpoint; // packets march mixtures only by midpoints
      plan.choosesIntegration = false;
    }
  }
  else
  {
    plan.marcher = Marcher::Device;
    plan.filter =
      FiltersBetweenTexelsExactly(frame.view.window) ? Filter::OfDevice : Filter::OfTexels;
    plan.filters8Bits = this->resources.AnyFits8Bits() && Filters8BitsExactly(frame.view.window);
    this->packets.Release(frame.view.window);
  }
  plan.sampleDistanceMm =
    std::max(plan.sampleDistanceMm, ShortestDistanceWithSkyMm(frame, plan.marcher));
}

void RayMarcher::DrawImage(const Frame& frame, MarchPlan plan)
{
  MarchWork work(
    std::numeric_limits<double>::infinity(), this->QuestionOf(frame, PartOfSearch, 1.0));
  plan.work = &work;
  vtkOpenGLRenderWindow* const drawnWindow = frame.view.window;
  FrameMarcher& marcher = this->MarcherOf(plan);
  const Viewport rays = RaysOf(plan.viewport, plan.imageSampleDistance);
  this->usedImageSampleDistance = double(plan.viewport.width) / rays.width;
  if (plan.pass != RayPass::Whole)
  {
    this->passes.Draw(frame, plan, marcher);
    return;
  }
  this->packets.ReleaseLayerDepths(drawnWindow);
  if (frame.casters.shadowing != Shadowing::AllVolumes)
  {
    this->dimming.Dim(frame, plan);
  }
  if (frame.image.toImages)
  {
    this->passes.DrawImages(frame, plan, marcher);
    return;
  }
  this->passes.Release(drawnWindow);
  if (plan.mostAccumulated > 0)
  {
    this->resampled.Release(drawnWindow);
    this->accumulator.Draw(frame, plan, marcher);
  }
  else if (rays.width == plan.viewport.width && rays.height == plan.viewport.height)
  {
    this->resampled.Release(drawnWindow);
    marcher.Draw(frame, plan);
  }
  else
  {
    this->resampled.Draw(frame, plan, marcher);
  }
}

FrameMarcher& RayMarcher::MarcherOf(const MarchPlan& plan)
{
  if (plan.marcher == Marcher::Processor)
  {
    return this->packets;
  }
  return this->shaders;
}

MemoryElsewhere RayMarcher::MemoryOfImages() const
{
  return { this->accumulator.Bytes() + this->resampled.Bytes() + this->passes.Bytes(),
    this->shaders.BytesOfBlocks() };
}

std::size_t RayMarcher::GraphicsMemoryBytes() const
{
  return this->resources.Bytes() + this->shaders.Bytes() + this->packets.Bytes() +
    this->dimming.Bytes() + this->MemoryOfImages().fixedBytes;
}

void RayMarcher::Release(vtkWindow* releasedWindow)
{
  if (this->window && releasedWindow && releasedWindow != this->window)
  {
    return; // the resources belong to another window
  }
  this->resources.Release(releasedWindow);
  this->boxes.Release();
  this->shaders.Release(releasedWindow);
  this->packets.Release(releasedWindow);
  this->dimming.Release(releasedWindow);
  this->resampled.Release(releasedWindow);
  this->accumulator.Release(releasedWindow);
  this->passes.Release(releasedWindow);
  this->foundStep.reset();
  this->tolerance.Forget();
  this->window = nullptr;
}

// While somebody interacts, a volume has steps of its own.
void RayMarcher::TakeSteps(const Frame& frame, MarchPlan& plan)
{
  if (this->commonSteps && !plan.isInteractive)
  {
    this->TakeCommonSteps(frame, plan);
  }
  else
  {
    this->SearchSteps(frame, plan);
  }
}

void RayMarcher::TakeCommonSteps(const Frame& frame, MarchPlan& plan)
{
  this->foundStep = this->commonSteps->step;
  if (plan.choosesIntegration)
  {
    plan.integration =
      this->commonSteps->isPreIntegrated ? Integration::PreIntegrated : Integration::Midpoint;
  }
  plan.sampleDistanceMm =
    std::max(this->foundStep->sampleDistance, ShortestDistanceWithSkyMm(frame, plan.marcher));
  plan.light = this->commonSteps->light;
  plan.wholeData = this->commonSteps->wholeData;
}

// If there is a tolerance, the steps that keep it replace the requested ones.
void RayMarcher::SearchSteps(const Frame& frame, MarchPlan& plan)
{
  if (!(plan.budget.StepTolerance() > 0.0))
  {
    this->foundStep.reset();
    this->tolerance.Forget();
    this->shaders.ReleaseTrial(frame.view.window);
    return;
  }
  this->Search(frame, plan);
  this->foundStep = this->tolerance.Choice()->step;
  plan.integration = this->tolerance.Choice()->integration;
  plan.light = this->tolerance.Choice()->light;
  // Shaders that count fetches may draw with steps that were found with packets.
  plan.sampleDistanceMm =
    std::max(this->foundStep->sampleDistance, ShortestDistanceWithSkyMm(frame, plan.marcher));
}

// An observer may stop the search between two trial images, and within one that packets march.
void RayMarcher::Search(const Frame& frame, const MarchPlan& plan)
{
  const auto stopIfUnwanted = [&]
  {
    if (frame.view.window->CheckAbortStatus())
    {
      throw DrawingStopped();
    }
  };
  bool hasTried = false;
  const VolumeMarch march = MarchOf(frame, plan);
  const bool dimsLight = IsInWayOfLights(march.settings) || IsInWayOfSky(march.settings);
  SearchWork work(dimsLight, this->QuestionOf(frame, 0.0, PartOfSearch));
  MarchPlan trialPlan = plan;
  trialPlan.work = &work.March();
  const auto drawTrials = [&](const std::vector<TrialImage>& images)
  {
    stopIfUnwanted();
    hasTried = true;
    work.Begin(images.front());
    std::vector<std::vector<float>> drawn = this->DrawTrials(frame, trialPlan, images);
    work.End(images.front(), drawn.front());
    return drawn;
  };
  const ToleranceInputs inputs = this->ToleranceInputsOf(frame, plan);
  try
  {
    this->tolerance.Update(march, this->resources.First(), inputs, drawTrials);
  }
  catch (const WorkUsedUp&)
  {
    this->tolerance.Take(inputs, work.Unfinished(FactsOf(march, this->resources.First())));
  }
  if (hasTried)
  {
    stopIfUnwanted();
  }
}

MarchWork::Question RayMarcher::QuestionOf(const Frame& frame, double from, double to) const
{
  vtkOpenGLRenderWindow* const drawnWindow = frame.view.window;
  return [this, drawnWindow, from, to, told = from](double part) mutable
  {
    told = std::max(told, from + part * (to - from)); // each trial image of a search begins anew
    this->tellProgress(told);
    const bool isWanted = drawnWindow->CheckAbortStatus() == 0;
    if (!drawnWindow->IsCurrent())
    {
      drawnWindow->MakeCurrent(); // an observer has drawn elsewhere
    }
    return isWanted;
  };
}

ToleranceInputs RayMarcher::ToleranceInputsOf(const Frame& frame, const MarchPlan& plan) const
{
  ToleranceInputs inputs;
  inputs.Add(MarchOf(frame, plan), this->resources.First());
  for (std::size_t i = 0; i < frame.others.size(); ++i)
  {
    inputs.Add(MarchOfOther(frame, plan, i), this->resources.Other(i));
  }
  return inputs;
}

}
