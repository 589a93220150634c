#include "Core/Quality/StepSearch.h"

#include "Core/Quality/ErrorBudget.h"
#include "Core/Quality/ImageError.h"

#include <iterator>
#include <map>
#include <optional>

namespace varimarch
{
namespace
{

// The order at surfaces that are all but opaque.
constexpr double OrderAtOpaqueSurfaces = 1.0;

// Bounds of the estimated order.
constexpr double LeastOrder = 0.7;
constexpr double MostOrder = 3.0;

// If an error is within these fractions of the limit, the power law predicts the distance at which
// it equals the limit.
constexpr double LeastNear = 0.6;
constexpr double MostNear = 1.25;

// The predicted distance is accepted if the error drawn there exceeds the limit by no more than the
// inaccuracy of the estimate.
constexpr double MostOfLimit = ErrorBudget::EstimateSlack;

// The distance of an earlier search is taken if its error is at least this fraction of the limit:
// longer steps would save less than the image that tries them.
constexpr double LeastOfEarlier = 0.85;
constexpr int MostTrials = 10;

// Ratio of the error to its change when the distance is halved; the change is 1 - 2^(-order
// halvings) of the error.
double ErrorPerChange(double order, double halvings)
{
  return 1.0 / (1.0 - std::exp2(-order * halvings));
}

double FractionOfLimit(const ImageError& error, const ErrorLimit& limit)
{
  constexpr double Infinite = 1e12; // stands for an error that is not a number
  return std::min(
    std::max(error.percentile999 / limit.percentile999, error.largest / limit.largest) / 255.0,
    Infinite);
}

/// A distance that was drawn, and its error.
struct Trial
{
  double distance;
  double percentile999;
  double ofLimit;
};

// Convergence order of the error between two distances.
double OrderBetween(const Trial& a, const Trial& b)
{
  const auto safeLog = [](double number) { return std::log2(std::max(number, 1e-12)); };
  return (safeLog(a.ofLimit) - safeLog(b.ofLimit)) / std::log2(a.distance / b.distance);
}

// Distance at which the error equals the limit, by a power law.
double DistanceOfLimit(const Trial& trial, double order)
{
  return trial.distance * std::pow(1.0 / std::max(trial.ofLimit, 1e-12), 1.0 / order);
}

/// The search itself. It draws the first distance and distances that are multiples of half an
/// octave from it, for any limit, so that similar limits give similar results.
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
    , order(range.supposedOrder)
  {
  }

  FoundSteps Find()
  {
    this->Keep(this->Try(this->InRange(this->first)));
    return this->FindFurther();
  }

  FoundSteps FindFrom(double earlier)
  {
    this->order = OrderAtOpaqueSurfaces; // no other distance of this image has told its order
    const Trial trial = this->Try(this->InRange(earlier));
    this->order = this->range.supposedOrder;
    if (trial.ofLimit >= LeastOfEarlier && trial.ofLimit <= MostOfLimit)
    {
      return this->Found(trial);
    }
    this->Keep(trial);
    return this->FindFurther();
  }

  StepChoice FirstThatKeeps(const std::vector<double>& distances)
  {
    StepChoice tried = {};
    for (const double distance : distances)
    {
      tried = this->Found(this->Try(this->InRange(distance))).choice;
      if (tried.KeepsLimit())
      {
        break;
      }
    }
    return tried;
  }

private:
  FoundSteps FindFurther()
  {
    for (int trials = 1; !this->IsAtEnd() && trials < MostTrials; ++trials)
    {
      if (this->range.isOfHalfOctaves ? !this->AreNeighbours() : !this->IsNear())
      {
        this->Keep(this->Try(this->NextDistance()));
      }
      else if (this->range.isOfHalfOctaves)
      {
        return this->Found(*this->keeps);
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

  double InRange(double distance) const
  {
    return std::clamp(distance, this->range.finest, this->range.coarsest);
  }

  // Returns a result. An excess below the inaccuracy of the estimate counts as kept.
  FoundSteps Found(const Trial& trial) const
  {
    const double ofLimit =
      trial.ofLimit <= MostOfLimit ? std::min(trial.ofLimit, 1.0) : trial.ofLimit;
    return { { trial.distance, trial.percentile999, ofLimit },
      this->exact.empty() ? this->finer.begin()->second : this->exact };
  }

  // True if the coarsest or finest allowed distance has been reached.
  bool IsAtEnd() const
  {
    return (this->keeps && this->keeps->distance >= this->range.coarsest) ||
      (!this->keeps && this->fails->distance <= this->range.finest);
  }

  // True if the limit lies between two distances half an octave apart.
  bool AreNeighbours() const
  {
    constexpr double Neighbours = 1.5;
    return this->keeps && this->fails &&
      this->fails->distance <= Neighbours * this->keeps->distance;
  }

  bool IsNear() const
  {
    return (this->keeps && this->keeps->ofLimit >= LeastNear) ||
      (this->fails && this->fails->ofLimit <= MostNear) || this->AreNeighbours();
  }

  Trial Try(double distance)
  {
    const std::vector<float> picture = this->draw(distance);
    double halvings = 2.0; // the exact image, if known, counts as one at a quarter of the distance
    const std::vector<float>& compared =
      this->exact.empty() ? this->FinerThan(distance, halvings) : this->exact;
    const ImageError change = CompareImages(picture.data(), compared.data(), picture.size() / 4);
    const auto trialOf = [&](double order)
    {
      const double factor = ErrorPerChange(order, halvings);
      return Trial{ distance, factor * change.percentile999 / 255.0,
        factor * FractionOfLimit(change, this->limit) };
    };
    // If the error falls more slowly than assumed, the finer distance has removed less of it.
    this->UpdateOrder(trialOf(UsualOrder));
    return trialOf(std::clamp(this->order, OrderAtOpaqueSurfaces, UsualOrder));
  }

  void Keep(const Trial& trial) { (trial.ofLimit <= 1.0 ? this->keeps : this->fails) = trial; }

  // Estimates the order from the previous distance, unless that is too close.
  void UpdateOrder(const Trial& trial)
  {
    constexpr double LeastOctaves = 0.45;
    if (this->last && std::abs(std::log2(trial.distance / this->last->distance)) >= LeastOctaves)
    {
      this->order = std::clamp(OrderBetween(trial, *this->last), LeastOrder, MostOrder);
    }
    this->last = trial;
  }

  // An image drawn at a third of the distance or less, and never more than a quarter of the first.
  // @param halvings  receives log2 of the ratio of the distances
  const std::vector<float>& FinerThan(double distance, double& halvings)
  {
    auto found = this->finer.upper_bound(distance / 3.0);
    if (found != this->finer.begin())
    {
      --found;
    }
    else
    {
      const double finerDistance =
        std::max(0.25 * std::min(distance, this->InRange(this->first)), 0.5 * this->range.finest);
      found = this->finer.find(finerDistance);
      if (found == this->finer.end())
      {
        found = this->finer.emplace(finerDistance, this->draw(finerDistance)).first;
      }
    }
    halvings = std::log2(distance / found->first);
    return found->second;
  }

  // Next distance to draw: slightly finer than the power law predicts, but not between distances
  // whose results are known.
  double NextDistance() const
  {
    constexpr double LevelsPerOctave = 2.0;
    constexpr double Rounding = 0.3; // in levels
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

  // The order around the limit if that is enclosed from both sides, otherwise the last estimate.
  double OrderNear() const
  {
    return this->keeps && this->fails
      ? std::clamp(OrderBetween(*this->fails, *this->keeps), LeastOrder, MostOrder)
      : this->order;
  }

  // Draws the distance at which the error should equal the limit. If the power law does not hold,
  // because a few rays have large errors, takes a distance half way there, or the one known to keep
  // the limit.
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
  std::map<double, std::vector<float>> finer; ///< images by distance, for comparison
  std::optional<Trial> keeps;                 ///< the longest distance so far that keeps the limit
  std::optional<Trial> fails;                 ///< the shortest distance so far that does not
  std::optional<Trial> last;
  double order;
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

FoundSteps FindSampleDistanceFrom(double earlier, const SampleDrawing& draw,
  const ErrorLimit& limit, const StepRange& range, double first)
{
  return Search(draw, limit, range, first, {}).FindFrom(earlier);
}

StepChoice FirstThatKeeps(const std::vector<double>& distances, const SampleDrawing& draw,
  const ErrorLimit& limit, const StepRange& range, double first)
{
  return Search(draw, limit, range, first, {}).FirstThatKeeps(distances);
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
  return FractionOfLimit(CompareImages(picture.data(), exact.data(), picture.size() / 4), limit);
}

}
