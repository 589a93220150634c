// The steps of the images of a RayMarcher.

#include "March/DrawingStopped.h"
#include "March/RayMarcher.h"
#include "March/SkyParameters.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>

namespace varimarch
{

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
