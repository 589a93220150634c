#include "March/SearchWork.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{

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
