#include "Scene/Median.h"

#include <algorithm>

namespace varimarch
{

double Median(std::vector<double> numbers)
{
  std::sort(numbers.begin(), numbers.end());
  const std::size_t middle = numbers.size() / 2;
  return numbers.size() % 2 ? numbers[middle] : 0.5 * (numbers[middle - 1] + numbers[middle]);
}

}
