#include "Scene/AnatomicalDirection.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace varimarch
{

std::string AnatomicalDirection(const double directionWorld[3])
{
  constexpr double Negligible = 0.05;
  constexpr std::array<const char*, 3> Letters = { "RL", "AP", "IS" }; // towards -, towards +
  const double length = std::hypot(directionWorld[0], directionWorld[1], directionWorld[2]);
  std::array<int, 3> axes = { 0, 1, 2 };
  std::stable_sort(axes.begin(), axes.end(),
    [&](int a, int b) { return std::abs(directionWorld[a]) > std::abs(directionWorld[b]); });
  std::string letters;
  for (const int axis : axes)
  {
    if (std::abs(directionWorld[axis]) > Negligible * length)
    {
      letters += Letters[axis][directionWorld[axis] > 0.0];
    }
  }
  return letters;
}

}
