#include "OrderFit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace varimarch
{

namespace
{

// The 97.5th percentile of Student's t distribution.
double StudentQuantile(int degreesOfFreedom)
{
  constexpr std::array<double, 10> Quantiles = { 12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365,
    2.306, 2.262, 2.228 };
  return Quantiles[std::size_t(std::min(degreesOfFreedom, int(Quantiles.size())) - 1)];
}

}

std::optional<OrderFit> FitOrder(const std::vector<OrderPoint>& points, double floor)
{
  std::vector<std::array<double, 2>> logs;
  for (const OrderPoint& point : points)
  {
    if (point.rmse > floor)
    {
      logs.push_back({ std::log(point.width), std::log(point.rmse) });
    }
  }
  const int count = int(logs.size());
  if (count < 3)
  {
    return std::nullopt;
  }
  std::array<double, 2> mean = {};
  for (const auto& [x, y] : logs)
  {
    mean[0] += x / count;
    mean[1] += y / count;
  }
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const auto& [x, y] : logs)
  {
    xx += (x - mean[0]) * (x - mean[0]);
    xy += (x - mean[0]) * (y - mean[1]);
    yy += (y - mean[1]) * (y - mean[1]);
  }
  const double order = xy / xx;
  const double variance = std::max(yy - order * xy, 0.0) / (count - 2);
  return OrderFit{ order, StudentQuantile(count - 2) * std::sqrt(variance / xx), count };
}

}
