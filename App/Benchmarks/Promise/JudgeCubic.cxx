#include "JudgeVolume.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{

double JudgeCrossing(const JudgeCubic& cubic, double value, double from, double to)
{
  const bool rises = ValueOf(cubic, from) < ValueOf(cubic, to);
  double u = 0.5 * (from + to);
  // Newton's method in a bracket; halving where a step would leave it.
  for (int i = 0; i < 60 && to - from > 1e-15; ++i)
  {
    const double off = ValueOf(cubic, u) - value;
    ((off < 0.0) == rises ? from : to) = u;
    const double slope = (3.0 * cubic[3] * u + 2.0 * cubic[2]) * u + cubic[1];
    const double next = u - off / slope;
    if (!(from < next && next < to))
    {
      u = 0.5 * (from + to);
      continue;
    }
    if (std::abs(next - u) < 1e-15)
    {
      return next;
    }
    u = next;
  }
  return u;
}

std::vector<double> JudgeTurns(const JudgeCubic& cubic)
{
  std::vector<double> turns = { 0.0 };
  const auto add = [&](double u)
  {
    if (turns.back() < u && u < 1.0)
    {
      turns.push_back(u);
    }
  };
  // The roots of 3 c3 u^2 + 2 c2 u + c1, by the formula that cancels nothing.
  const double a = 3.0 * cubic[3];
  const double half = cubic[2];
  const double discriminant = half * half - a * cubic[1];
  if (discriminant >= 0.0)
  {
    const double q = -(half + std::copysign(std::sqrt(discriminant), half));
    const double one = a != 0.0 ? q / a : -1.0;
    const double other = q != 0.0 ? cubic[1] / q : -1.0;
    add(std::min(one, other));
    add(std::max(one, other));
  }
  turns.push_back(1.0);
  return turns;
}

}
