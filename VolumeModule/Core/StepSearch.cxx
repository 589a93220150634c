#include "Core/StepSearch.h"

#include "Core/ImageError.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace varimarch
{

namespace
{

// An order of 1.6: what is left of the error when the distance is halved is 1/3 of it.
constexpr double ErrorPerChange = 1.5;

struct Estimate
{
  double percentile999;
  double ofLimit;
};

Estimate EstimateError(
  const std::vector<float>& picture, const std::vector<float>& finer, const ErrorLimit& limit)
{
  const ImageError change = CompareImages(picture.data(), finer.data(), picture.size() / 4);
  const double percentile999 = ErrorPerChange * change.percentile999 / 255.0;
  const double largest = ErrorPerChange * change.largest / 255.0;
  return { percentile999, std::max(percentile999 / limit.percentile999, largest / limit.largest) };
}

/// The pictures and estimates of one search, by level: the coarsest distance is halved as often as
/// the level says.
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
    return std::max(int(std::log2(this->range.coarsest / this->range.finest)), 0);
  }

  double Distance(int level) const { return std::ldexp(this->range.coarsest, -level); }

  int Nearest(double distance) const
  {
    const double level = std::round(std::log2(this->range.coarsest / distance));
    return int(std::clamp(level, 0.0, double(this->Finest())));
  }

  Estimate At(int level)
  {
    return EstimateError(this->Picture(level), this->Picture(level + 1), this->limit);
  }

private:
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

/// Between two levels the error is taken as a power of the distance.
StepChoice Between(
  const Levels& levels, int level, const Estimate& estimate, const Estimate& coarser)
{
  const auto safeLog = [](double number) { return std::log2(std::max(number, 1e-12)); };
  const double slope = safeLog(coarser.ofLimit) - safeLog(estimate.ofLimit);
  const double part = slope > 0.0 ? std::clamp(-safeLog(estimate.ofLimit) / slope, 0.0, 1.0) : 0.0;
  const double errorSlope = safeLog(coarser.percentile999) - safeLog(estimate.percentile999);
  return { levels.Distance(level) * std::exp2(part),
    estimate.percentile999 * std::exp2(part * errorSlope), 1.0 };
}

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
    if (coarser.ofLimit > 1.0)
    {
      return Between(levels, level, estimate, coarser);
    }
    estimate = coarser;
    --level;
  }
  return { levels.Distance(level), estimate.percentile999, estimate.ofLimit };
}

double ErrorOfLimit(const SampleDrawing& draw, const ErrorLimit& limit, double sampleDistance)
{
  return EstimateError(draw(sampleDistance), draw(0.5 * sampleDistance), limit).ofLimit;
}

}
