#include "Frame/MarchPlan.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace varimarch
{

namespace
{

void TakePlan(const MarchPlan& plan, RenderSettings& settings)
{
  const bool isWhole = plan.marcher == Marcher::Processor || plan.pass != RayPass::Block;
  const bool mayOcclude = isWhole && plan.isLit && !plan.isInteractive;
  settings.filter = settings.nearest ? Filter::OfDevice : plan.filter;
  settings.shading = settings.shading && plan.isLit;
  settings.occlusion = settings.occlusion && mayOcclude;
  settings.occludesOthers = settings.occludesOthers && mayOcclude;
}

double DistanceOfLightMm(const MarchPlan& plan)
{
  return plan.light.sampleDistanceMm > 0.0 ? plan.light.sampleDistanceMm : plan.sampleDistanceMm;
}

void TakeFindings(const VolumeFindings& findings, RenderSettings& settings)
{
  settings.skipsBricks = findings.skipsBricks;
  settings.gaps = findings.hasGaps;
}

}

double MarchPlan::LightStepMm(double spacingMm) const
{
  const double step = DistanceOfLightMm(*this);
  return step < spacingMm ? std::sqrt(step * spacingMm) : step;
}

double MarchPlan::OcclusionStepMm(double spacingMm) const
{
  return spacingMm * std::cbrt(std::min(DistanceOfLightMm(*this) / spacingMm, 1.0));
}

MarchPlan MarchPlan::WithPass(RayPass otherPass) const
{
  MarchPlan plan = *this;
  plan.pass = otherPass;
  return plan;
}

MarchPlan MarchPlan::WithRole(ShaderRole otherRole) const
{
  MarchPlan plan = *this;
  plan.role = otherRole;
  return plan;
}

MarchPlan MarchPlan::WithViewport(const Viewport& otherViewport) const
{
  MarchPlan plan = *this;
  plan.viewport = otherViewport;
  return plan;
}

glm::ivec2 MarchPlan::ImagePixels() const
{
  return this->isTrial ? this->triedPixels
                       : glm::ivec2(this->viewport.width, this->viewport.height);
}

Viewport TrialPixels(const Viewport& image, int most)
{
  constexpr int BlockColumns = 4;
  constexpr int BlockRows = 2;
  const int usualRows = int(std::sqrt(0.5 * most));
  const int columns = most / std::min(image.height, usualRows);
  const int width = columns < image.width ? columns / BlockColumns * BlockColumns : image.width;
  const int rows = most / width;
  return { 0, 0, width, rows < image.height ? rows / BlockRows * BlockRows : image.height };
}

MarchPlan PlanOf(const Frame& frame, const std::optional<PictureQuality>& quality)
{
  MarchPlan plan;
  plan.integration = frame.settings.integration;
  plan.choosesIntegration = frame.quality.choosesIntegration;
  plan.budget = frame.quality.budget;
  plan.sampleDistanceMm = frame.quality.sampleDistanceMm;
  plan.imageSampleDistance = frame.image.sampleDistance;
  plan.mostAccumulated = frame.accumulation.mostImages;
  plan.volumes.resize(1 + frame.others.size());
  plan.coarser.resize(frame.coarser.size());
  plan.pass = frame.pass.kind;
  plan.viewport = frame.view.viewport;
  if (quality)
  {
    const auto& [shortest, longest] = frame.image.interactiveSampleDistances;
    plan.imageSampleDistance = std::max(
      plan.imageSampleDistance, std::clamp(quality->imageSampleDistance, shortest, longest));
    plan.mostAccumulated = 0;
    plan.isInteractive = true;
    plan.budget = plan.budget.WithStepFactor(quality->toleranceFactor);
    plan.sampleDistanceMm *= quality->toleranceFactor;
  }
  return plan;
}

VolumeMarch MarchOf(const Frame& frame, const MarchPlan& plan)
{
  RenderSettings settings = frame.settings;
  settings.integration = plan.integration;
  settings.pass = plan.pass;
  settings.role = plan.role;
  settings.shadows = settings.shadows && settings.pass != RayPass::Block; // a block is no whole
  TakePlan(plan, settings);
  settings.countFetches = settings.countFetches && !plan.isTrial; // errors are errors of colours
  TakeFindings(plan.volumes.front(), settings);
  settings.others.clear();
  for (std::size_t i = 0; i < frame.others.size(); ++i)
  {
    settings.others.push_back(MarchOfOther(frame, plan, i).settings);
  }
  return { frame, plan, std::move(settings) };
}

VolumeMarch MarchOfOther(const Frame& frame, const MarchPlan& plan, std::size_t other)
{
  RenderSettings settings = frame.others[other].settings;
  TakePlan(plan, settings);
  TakeFindings(plan.volumes[other + 1], settings);
  return { frame.others[other], plan, std::move(settings) };
}

VolumeMarch MarchOfCoarser(const Frame& frame, const MarchPlan& plan, std::size_t level)
{
  MarchPlan ofLevel = plan;
  ofLevel.volumes = { plan.coarser[level] };
  return MarchOf(frame.coarser[level], ofLevel);
}

}
