#include "Core/StepSearch.h"

#include "Core/ImageError.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>

namespace varimarch
{

namespace
{

// Of an error as a power of the distance: rules are of order 2, and voxels have kinks.
constexpr double SupposedOrder = 1.6;
// As it may be found.
constexpr double LeastOrder = 0.7;
constexpr double MostOrder = 3.0;

// A search looks for a distance whose error is this part of the limit, and ends with one that
// keeps the limit and uses at least so much of it.
constexpr double WantedOfLimit = 0.9;
constexpr double LeastOfLimit = 0.75;
constexpr int MostTrials = 8;

// What halving the distance so often changes is 1 - 2^(-order halvings) of the error.
double ErrorPerChange(double order, double halvings)
{
  return 1.0 / (1.0 - std::exp2(-order * halvings));
}

double OfLimit(const ImageError& error, const ErrorLimit& limit)
{
  constexpr double Infinite = 1e12; // of what is not a number
  return std::min(
    std::max(error.percentile999 / limit.percentile999, error.largest / limit.largest) / 255.0,
    Infinite);
}

/// A distance that was tried, and its error.
struct Trial
{
  double distance;
  double percentile999;
  double ofLimit;
};

// The order of an error between two distances.
double OrderBetween(const Trial& a, const Trial& b)
{
  const auto safeLog = [](double number) { return std::log2(std::max(number, 1e-12)); };
  return (safeLog(a.ofLimit) - safeLog(b.ofLimit)) / std::log2(a.distance / b.distance);
}

double DistanceForWanted(const Trial& trial, double order)
{
  return trial.distance * std::pow(WantedOfLimit / std::max(trial.ofLimit, 1e-12), 1.0 / order);
}

class Search
{
public:
  Search(const SampleDrawing& draw, const ErrorLimit& limit, const StepRange& range,
    const std::vector<float>& exact)
    : draw(draw)
    , limit(limit)
    , range(range)
    , exact(exact)
  {
  }

  FoundSteps Find(double first)
  {
    this->Try(this->InRange(first));
    for (int trials = 1; !this->IsFound() && trials < MostTrials; ++trials)
    {
      this->Try(this->NextDistance());
    }
    if (!this->keeps && this->fails->distance > this->range.finest)
    {
      this->Try(this->range.finest);
    }
    const Trial& found = this->keeps ? *this->keeps : *this->fails;
    return { { found.distance, found.percentile999, found.ofLimit },
      this->exact.empty() ? this->finer.begin()->second : this->exact };
  }

private:
  double InRange(double distance) const
  {
    return std::clamp(distance, this->range.finest, this->range.coarsest);
  }

  bool IsFound() const
  {
    constexpr double Near = 1.15;
    if (!this->keeps)
    {
      return this->fails->distance <= this->range.finest;
    }
    return this->keeps->ofLimit >= LeastOfLimit || this->keeps->distance >= this->range.coarsest ||
      (this->fails && this->fails->distance <= Near * this->keeps->distance);
  }

  void Try(double distance)
  {
    const std::vector<float> picture = this->draw(distance);
    double halvings = std::numeric_limits<double>::infinity();
    const std::vector<float>& compared =
      this->exact.empty() ? this->FinerThan(distance, halvings) : this->exact;
    const ImageError change = CompareImages(picture.data(), compared.data(), picture.size() / 4);
    const auto trialOf = [&](double order)
    {
      const double factor = ErrorPerChange(order, halvings);
      return Trial{ distance, factor * change.percentile999 / 255.0,
        factor * OfLimit(change, this->limit) };
    };
    // Where the error falls slower than was supposed a finer distance has changed less of it.
    const Trial supposed = trialOf(SupposedOrder);
    this->UpdateOrder(supposed);
    constexpr double OrderAtOpaqueSurfaces = 1.0;
    const Trial trial = trialOf(std::clamp(this->order, OrderAtOpaqueSurfaces, SupposedOrder));
    (trial.ofLimit <= 1.0 ? this->keeps : this->fails) = trial;
  }

  // By the distance that was tried before, if it is not too near to tell.
  void UpdateOrder(const Trial& trial)
  {
    constexpr double LeastOctaves = 0.5;
    if (this->last && std::abs(std::log2(trial.distance / this->last->distance)) >= LeastOctaves)
    {
      this->order = std::clamp(OrderBetween(trial, *this->last), LeastOrder, MostOrder);
    }
    this->last = trial;
  }

  // A picture at a third of the distance or less, by how many halvings that is finer.
  const std::vector<float>& FinerThan(double distance, double& halvings)
  {
    auto found = this->finer.upper_bound(distance / 3.0);
    if (found != this->finer.begin())
    {
      --found;
    }
    else
    {
      const double finerDistance = std::max(0.25 * distance, 0.5 * this->range.finest);
      found = this->finer.find(finerDistance);
      if (found == this->finer.end())
      {
        found = this->finer.emplace(finerDistance, this->draw(finerDistance)).first;
      }
    }
    halvings = std::log2(distance / found->first);
    return found->second;
  }

  double NextDistance() const
  {
    if (this->keeps && this->fails)
    {
      const double octaves = std::log2(this->fails->distance / this->keeps->distance);
      const double order =
        std::clamp(OrderBetween(*this->fails, *this->keeps), LeastOrder, MostOrder);
      const double between =
        std::log2(DistanceForWanted(*this->keeps, order) / this->keeps->distance);
      return this->keeps->distance * std::exp2(std::clamp(between, 0.15 * octaves, 0.85 * octaves));
    }
    // Errors far from the limit tell little of where it is.
    constexpr double LeastFactor = 1.25;
    constexpr double MostFactor = 16.0;
    if (this->keeps)
    {
      const double factor = DistanceForWanted(*this->keeps, this->order) / this->keeps->distance;
      return this->InRange(this->keeps->distance * std::clamp(factor, LeastFactor, MostFactor));
    }
    const double factor = this->fails->distance / DistanceForWanted(*this->fails, this->order);
    return this->InRange(this->fails->distance / std::clamp(factor, LeastFactor, MostFactor));
  }

  const SampleDrawing& draw;
  ErrorLimit limit;
  StepRange range;
  const std::vector<float>& exact;
  std::map<double, std::vector<float>> finer; ///< pictures by distance, for comparison
  std::optional<Trial> keeps;                 ///< the longest distance that keeps the limit, so far
  std::optional<Trial> fails;                 ///< the shortest that does not
  std::optional<Trial> last;
  double order = SupposedOrder;
};

}

bool IsBetter(const StepChoice& choice, double cost, const StepChoice& other)
{
  return other.KeepsLimit() ? choice.sampleDistance >= cost * other.sampleDistance
                            : choice.ofLimit < other.ofLimit;
}

FoundSteps FindSampleDistance(const SampleDrawing& draw, const ErrorLimit& limit,
  const StepRange& range, double first, const std::vector<float>& exact)
{
  return Search(draw, limit, range, exact).Find(first);
}

double DifferenceOfLimit(
  const std::vector<float>& a, const std::vector<float>& b, const ErrorLimit& limit)
{
  const ImageError difference = CompareImages(a.data(), b.data(), a.size() / 4);
  return difference.percentile999 / (255.0 * limit.percentile999);
}

double ErrorOfLimit(
  const std::vector<float>& picture, const std::vector<float>& exact, const ErrorLimit& limit)
{
  return OfLimit(CompareImages(picture.data(), exact.data(), picture.size() / 4), limit);
}

}
