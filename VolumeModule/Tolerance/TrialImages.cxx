#include "Tolerance/TrialImages.h"

#include "Core/Quality/StepSearch.h"
#include "March/RayParametersBuilder.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace varimarch
{

namespace
{

bool IsSame(const TrialImage& one, const TrialImage& other)
{
  constexpr double Same = 1e-6;
  return one.integration == other.integration && one.isLit == other.isLit &&
    one.hasSmallTable == other.hasSmallTable && one.isSmall == other.isSmall &&
    one.light == other.light &&
    std::abs(one.sampleDistanceMm / other.sampleDistanceMm - 1.0) < Same;
}

}

MarchPlan TrialImage::PlanOf(const MarchPlan& image) const
{
  const Viewport all = RaysOf(image.viewport, image.imageSampleDistance);
  constexpr int RaysIfSmall = 48 * 24;
  MarchPlan tried =
    image.WithViewport(this->isSmall ? TrialPixels(all, RaysIfSmall) : TrialPixels(all));
  tried.pass = RayPass::Whole;
  tried.integration = this->integration;
  tried.sampleDistanceMm = this->sampleDistanceMm;
  tried.isTrial = true;
  tried.triedPixels = { all.width, all.height };
  tried.isLit = this->isLit;
  tried.hasSmallTable = this->hasSmallTable;
  tried.light = this->light;
  return tried;
}

const std::vector<float>& TrialImages::Of(const TrialImage& image)
{
  if (!this->Find(image))
  {
    const std::vector<TrialImage> images = this->AllWith(image);
    std::vector<std::vector<float>> all = this->draw(images);
    for (std::size_t i = 0; i < images.size(); ++i)
    {
      this->drawn.push_back({ images[i], std::move(all[i]) });
    }
  }
  return this->Find(image)->rgba;
}

const TrialImages::Drawn* TrialImages::Find(const TrialImage& image) const
{
  const auto found = std::find_if(this->drawn.begin(), this->drawn.end(),
    [&](const Drawn& one) { return IsSame(one.image, image); });
  return found == this->drawn.end() ? nullptr : &*found;
}

// There is one table at a time, for one distance.
bool TrialImages::IsByTable(const TrialImage& image) const
{
  return image.integration == Integration::PreIntegrated &&
    (this->preIntegratesByTable || !image.isLit);
}

std::vector<TrialImage> TrialImages::AllWith(const TrialImage& image) const
{
  std::vector<TrialImage> images = { image };
  const bool isOneOfAKind = image.light.sampleDistanceMm > 0.0;
  if (!this->range.isOfHalfOctaves || this->IsByTable(image) || isOneOfAKind)
  {
    return images;
  }
  for (const double distanceMm : DistancesDrawnWith(image.sampleDistanceMm, this->range))
  {
    TrialImage other = image;
    other.sampleDistanceMm = distanceMm;
    const bool isAmong = std::any_of(
      images.begin(), images.end(), [&](const TrialImage& one) { return IsSame(one, other); });
    if (!isAmong && !this->Find(other))
    {
      images.push_back(other);
    }
  }
  return images;
}

// Rays to lights begin at each step and have as many, so that the work grows like the square of the
// number of steps, or like that number where light is kept in lattices.
void SearchWork::Begin(const TrialImage& image)
{
  this->beforeSeconds = this->march.Seconds();
  if (this->tried.size() < 2 || !image.isLit)
  {
    return;
  }
  const Tried& finest = this->tried.back();
  const Tried& coarser = this->tried[this->tried.size() - 2];
  const double growth = std::log(finest.seconds / coarser.seconds) /
    std::log(coarser.image.sampleDistanceMm / finest.image.sampleDistanceMm);
  const double times = finest.image.sampleDistanceMm / image.sampleDistanceMm;
  const double foreseen = finest.seconds * std::pow(times, std::clamp(growth, 1.0, 2.0));
  if (times > 1.0 && this->beforeSeconds + foreseen > this->mostSeconds)
  {
    throw WorkUsedUp();
  }
}

void SearchWork::End(const TrialImage& image, const std::vector<float>& rgba)
{
  if (this->march.IsUsedUp())
  {
    throw WorkUsedUp();
  }
  if (!image.isLit || image.isSmall)
  {
    return;
  }
  constexpr double Shortest = 1e-4; // the clock ticks
  const double seconds = std::max(this->march.Seconds() - this->beforeSeconds, Shortest);
  const auto isFiner = [](double distanceMm, const Tried& one)
  { return distanceMm > one.image.sampleDistanceMm; };
  const auto place =
    std::upper_bound(this->tried.begin(), this->tried.end(), image.sampleDistanceMm, isFiner);
  const bool isKnown =
    place != this->tried.begin() && (place - 1)->image.sampleDistanceMm == image.sampleDistanceMm;
  if (!isKnown)
  {
    this->tried.insert(place, { image, rgba, seconds });
  }
}

ToleranceChoice SearchWork::Unfinished(const SearchFacts& facts) const
{
  constexpr double Unknown = 1.0; // the largest error of a channel
  ToleranceChoice choice = {};
  choice.integration = this->tried.empty() ? facts.usual : this->tried.back().image.integration;
  choice.step.sampleDistance =
    this->tried.empty() ? facts.firstMm : this->tried.back().image.sampleDistanceMm;
  choice.light = this->tried.empty() ? LightSource() : this->tried.back().image.light;
  const double ofLimit = this->tried.size() < 2
    ? Unknown / facts.limit.percentile999
    : ErrorOfLimit(this->tried[this->tried.size() - 2].rgba, this->tried.back().rgba, facts.limit);
  constexpr double LeastBeyond = 1.01; // it is not known to keep the limit
  choice.step.ofLimit = std::max(ofLimit, LeastBeyond);
  choice.step.error = std::min(choice.step.ofLimit * facts.limit.percentile999, Unknown);
  choice.step.isOfBoundedWork = true;
  return choice;
}

}
