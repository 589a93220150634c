#include "Core/StepSearch.h"

#include "Core/ImageError.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace varimarch
{

namespace
{

constexpr double SupposedOrder = 1.6;

// A distance that was not tried before may be off by so much of the limit.
constexpr double MostOfLimit = 1.2;

// What halving the distance so often changes is 1 - 2^(-order halvings) of the error.
double ErrorPerChange(double order, double halvings)
{
  return 1.0 / (1.0 - std::exp2(-order * halvings));
}

struct Estimate
{
  double halvings; ///< that it was made by
  double percentile999;
  double ofLimit;
};

Estimate EstimateError(const std::vector<float>& picture, const std::vector<float>& finer,
  double halvings, const ErrorLimit& limit)
{
  const ImageError change = CompareImages(picture.data(), finer.data(), picture.size() / 4);
  const double errorPerChange = ErrorPerChange(SupposedOrder, halvings);
  const double percentile999 = errorPerChange * change.percentile999 / 255.0;
  const double largest = errorPerChange * change.largest / 255.0;
  return { halvings, percentile999,
    std::max(percentile999 / limit.percentile999, largest / limit.largest) };
}

/// The pictures and estimates of one search, by level: the coarsest distance is halved as often as
/// the level says. The last level that is searched is at the finest distance, and one more is half
/// of it.
class Levels
{
public:
  Levels(const SampleDrawing& draw, const ErrorLimit& limit, const StepRange& range)
    : draw(draw)
    , limit(limit)
    , range(range)
  {
  }

  int Finest() const
  {
    constexpr double Rounding = 1e-6;
    return int(std::ceil(std::log2(this->range.coarsest / this->range.finest) - Rounding));
  }

  double Distance(int level) const
  {
    const int finest = this->Finest();
    return level < finest ? std::ldexp(this->range.coarsest, -level)
                          : std::ldexp(this->range.finest, finest - level);
  }

  int Nearest(double distance) const
  {
    const double level = std::round(std::log2(this->range.coarsest / distance));
    return int(std::clamp(level, 0.0, double(this->Finest())));
  }

  Estimate At(int level)
  {
    const int finer = this->Finer(level);
    return EstimateError(this->Picture(level), this->Picture(finer),
      std::log2(this->Distance(level) / this->Distance(finer)), this->limit);
  }

  /// At a distance beside a level, by what that one was judged by.
  Estimate Beside(int level, double distance)
  {
    const int finer = this->Finer(level);
    return EstimateError(this->draw(distance), this->Picture(finer),
      std::log2(distance / this->Distance(finer)), this->limit);
  }

private:
  // Quarters tell more of an error than halves, but none is drawn below half of the finest.
  int Finer(int level) const { return std::min(level + 2, this->Finest() + 1); }

  const std::vector<float>& Picture(int level)
  {
    std::vector<float>& picture = this->pictures[level];
    if (picture.empty())
    {
      picture = this->draw(this->Distance(level));
    }
    return picture;
  }

  const SampleDrawing& draw;
  ErrorLimit limit;
  StepRange range;
  std::map<int, std::vector<float>> pictures;
};

/// Between two levels the error is taken as a power of the distance. Where it falls slower than was
/// supposed, as at opaque surfaces, a finer distance has changed a smaller part of it.
struct PowerLaw
{
  double distance; ///< of the finer level
  double error;    ///< there, the 99.9th percentile
  double octaves;  ///< by which a distance is longer whose error is the limit
  double errorSlope;

  StepChoice At(double partOfOctaves) const
  {
    const double longer = partOfOctaves * this->octaves;
    return { this->distance * std::exp2(longer), this->error * std::exp2(longer * this->errorSlope),
      1.0 };
  }
};

/// @param octavesApart  how much longer the coarser distance is
PowerLaw LawBetween(
  double distance, const Estimate& estimate, const Estimate& coarser, double octavesApart)
{
  const auto safeLog = [](double number) { return std::log2(std::max(number, 1e-12)); };
  const auto slopeOf = [&](double error, double coarserError)
  { return (safeLog(coarserError) - safeLog(error)) / octavesApart; };
  const double slope = slopeOf(estimate.ofLimit, coarser.ofLimit);
  const double errorSlope = slopeOf(estimate.percentile999, coarser.percentile999);
  const double order = std::clamp(slope, 1.0, SupposedOrder);
  const double missed = std::log2(
    ErrorPerChange(order, estimate.halvings) / ErrorPerChange(SupposedOrder, estimate.halvings));
  const double octaves = slope > 0.0
    ? std::clamp((-safeLog(estimate.ofLimit) - missed) / slope, 0.0, octavesApart)
    : octavesApart;
  return { distance, estimate.percentile999 * std::exp2(missed), octaves, errorSlope };
}

// Where few rays err, and these much, the error is no power of the distance: what is found is
// tried, and then half of the way there.
std::optional<StepChoice> FindBetween(
  Levels& levels, int level, const Estimate& estimate, const Estimate& coarser)
{
  const double distance = levels.Distance(level);
  const PowerLaw law =
    LawBetween(distance, estimate, coarser, std::log2(levels.Distance(level - 1) / distance));
  for (const double part : { 1.0, 0.5 })
  {
    const StepChoice choice = law.At(part);
    if (levels.Beside(level, choice.sampleDistance).ofLimit <= MostOfLimit)
    {
      return choice;
    }
  }
  return std::nullopt;
}

}

bool IsBetter(const StepChoice& choice, double cost, const StepChoice& other)
{
  return !other.KeepsLimit() || choice.sampleDistance >= cost * other.sampleDistance;
}

StepChoice FindSampleDistance(
  const SampleDrawing& draw, const ErrorLimit& limit, const StepRange& range, double first)
{
  Levels levels(draw, limit, range);
  int level = levels.Nearest(first);
  Estimate estimate = levels.At(level);
  while (estimate.ofLimit > 1.0 && level < levels.Finest())
  {
    estimate = levels.At(++level);
  }
  while (estimate.ofLimit <= 1.0 && level > 0)
  {
    const Estimate coarser = levels.At(level - 1);
    if (coarser.ofLimit > 1.0 || level == 1)
    {
      if (const std::optional<StepChoice> choice = FindBetween(levels, level, estimate, coarser))
      {
        return *choice;
      }
      break;
    }
    estimate = coarser;
    --level;
  }
  return { levels.Distance(level), estimate.percentile999, estimate.ofLimit };
}

double DifferenceOfLimit(
  const std::vector<float>& a, const std::vector<float>& b, const ErrorLimit& limit)
{
  const ImageError difference = CompareImages(a.data(), b.data(), a.size() / 4);
  return difference.percentile999 / (255.0 * limit.percentile999);
}

double ErrorOfLimit(
  const SampleDrawing& draw, const ErrorLimit& limit, const StepRange& range, double sampleDistance)
{
  const double finer = std::max(0.25 * sampleDistance, 0.5 * range.finest);
  return EstimateError(draw(sampleDistance), draw(finer), std::log2(sampleDistance / finer), limit)
    .ofLimit;
}

}
