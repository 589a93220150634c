#ifndef Varimarch_Core_Quality_Percentile_h
#define Varimarch_Core_Quality_Percentile_h

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace varimarch
{

/// The smallest number that at least a given fraction of the numbers does not exceed.
/// @param numbers  at least one
/// @param part  the fraction, (0, 1]
inline double Percentile(std::vector<double> numbers, double part)
{
  const auto rank = std::size_t(std::ceil(part * double(numbers.size())));
  const auto position = numbers.begin() + std::ptrdiff_t(std::max<std::size_t>(rank, 1) - 1);
  std::nth_element(numbers.begin(), position, numbers.end());
  return *position;
}

}

#endif
