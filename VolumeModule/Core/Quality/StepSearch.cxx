#include "Core/Quality/StepSearch.h"

#include "Core/Quality/ImageError.h"

#include <algorithm>
#include <cmath>
#include <iterator>
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

// Where an error is such a part of the limit, its power tells the distance at which it is all of
// it.
constexpr double LeastNear = 0.6;
constexpr double MostNear = 1.25;
// That distance is taken if the error tried there is no more off than estimates are.
constexpr double MostOfLimit = 1.15;

constexpr int MostTrials = 10;

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

// Where the error is the limit, as a power of the distance.
double DistanceOfLimit(const Trial& trial, double order)
{
  return trial.distance * std::pow(1.0 / std::max(trial.ofLimit, 1e-12), 1.0 / order);
}

/// Distances that are tried are the first one and others that are half octaves apart, whatever the
/// limit: so that what is found for one limit is much like what is found for the next.
class Search
{
public:
  Search(const SampleDrawing& draw, const ErrorLimit& limit, const StepRange& range, double first,
    const std::vector<float>& exact)
    : draw(draw)
    , limit(limit)
    , range(range)
    , first(first)
    , exact(exact)
  {
  }

  FoundSteps Find()
  {
    this->Keep(this->Try(this->InRange(this->first)));
    for (int trials = 1; !this->IsAtEnd() && trials < MostTrials; ++trials)
    {
      if (!this->IsNear())
      {
        this->Keep(this->Try(this->NextDistance()));
      }
      else if (const std::optional<Trial> found = this->TryDistanceOfLimit())
      {
        return this->Found(*found);
      }
    }
    if (!this->keeps && this->fails->distance > this->range.finest)
    {
      this->Keep(this->Try(this->range.finest));
    }
    return this->Found(this->keeps ? *this->keeps : *this->fails);
  }

private:
  double InRange(double distance) const
  {
    return std::clamp(distance, this->range.finest, this->range.coarsest);
  }

  // What is over the limit by no more than estimates are off counts as kept.
  FoundSteps Found(const Trial& trial) const
  {
    const double ofLimit =
      trial.ofLimit <= MostOfLimit ? std::min(trial.ofLimit, 1.0) : trial.ofLimit;
    return { { trial.distance, trial.percentile999, ofLimit },
      this->exact.empty() ? this->finer.begin()->second : this->exact };
  }

  // Of what may be taken.
  bool IsAtEnd() const
  {
    return (this->keeps && this->keeps->distance >= this->range.coarsest) ||
      (!this->keeps && this->fails->distance <= this->range.finest);
  }

  bool IsNear() const
  {
    constexpr double Neighbours = 1.5;
    return (this->keeps && this->keeps->ofLimit >= LeastNear) ||
      (this->fails && this->fails->ofLimit <= MostNear) ||
      (this->keeps && this->fails && this->fails->distance <= Neighbours * this->keeps->distance);
  }

  Trial Try(double distance)
  {
    const std::vector<float> picture = this->draw(distance);
    double halvings = 2.0; // a known picture has an error like that of a quarter
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
    this->UpdateOrder(trialOf(SupposedOrder));
    constexpr double OrderAtOpaqueSurfaces = 1.0;
    return trialOf(std::clamp(this->order, OrderAtOpaqueSurfaces, SupposedOrder));
  }

  void Keep(const Trial& trial) { (trial.ofLimit <= 1.0 ? this->keeps : this->fails) = trial; }

  // By the distance that was tried before, if it is not too near to tell.
  void UpdateOrder(const Trial& trial)
  {
    constexpr double LeastOctaves = 0.45;
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

  // Rather a finer one than what the error says, but beyond what was tried.
  double NextDistance() const
  {
    constexpr double LevelsPerOctave = 2.0;
    constexpr double Rounding = 0.3; // of a level
    const Trial& from = this->keeps ? *this->keeps : *this->fails;
    const double wanted = this->InRange(DistanceOfLimit(from, this->OrderNear()));
    const auto levelOf = [&](double distance)
    { return LevelsPerOctave * std::log2(this->first / distance); };
    constexpr double Same = 1e-6;
    const auto coarserThan = [&](const Trial& trial)
    { return std::ceil(levelOf(trial.distance) - Same) - 1.0; };
    const auto finerThan = [&](const Trial& trial)
    { return std::floor(levelOf(trial.distance) + Same) + 1.0; };
    double level = std::ceil(levelOf(wanted) - Rounding);
    level = this->keeps ? std::min(level, coarserThan(*this->keeps)) : level;
    level = this->fails ? std::max(level, finerThan(*this->fails)) : level;
    return this->InRange(this->first * std::exp2(-level / LevelsPerOctave));
  }

  // Around the limit where that is known from both sides, else as last found.
  double OrderNear() const
  {
    return this->keeps && this->fails
      ? std::clamp(OrderBetween(*this->fails, *this->keeps), LeastOrder, MostOrder)
      : this->order;
  }

  // Where few rays err, and these much, the error is no power of the distance:
  // then half of the way there, or what is known to keep the limit.
  std::optional<Trial> TryDistanceOfLimit()
  {
    const Trial near = this->keeps ? *this->keeps : *this->fails;
    const double distance = this->InRange(DistanceOfLimit(near, this->OrderNear()));
    const double farthest = this->fails ? this->fails->distance : distance;
    const Trial trial = this->Try(std::min(distance, farthest));
    if (trial.ofLimit <= MostOfLimit)
    {
      return trial;
    }
    if (!this->keeps)
    {
      this->Keep(trial);
      return std::nullopt;
    }
    const Trial half = this->Try(std::sqrt(near.distance * trial.distance));
    return half.ofLimit <= MostOfLimit ? half : near;
  }

  const SampleDrawing& draw;
  ErrorLimit limit;
  StepRange range;
  double first;
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
  return Search(draw, limit, range, first, exact).Find();
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
