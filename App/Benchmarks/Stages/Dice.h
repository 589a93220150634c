#ifndef Varimarch_Benchmarks_Dice_h
#define Varimarch_Benchmarks_Dice_h

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace varimarch
{

/// Random choices that are the same on every computer, because the distributions of the standard
/// library are not.
class Dice
{
public:
  /// @param subject  a number for each subject, so that more choices in one do not change another
  Dice(std::uint64_t seed, std::uint64_t subject)
    : engine(seed * 64 + subject)
  {
  }

  double Between(double lower, double upper) { return lower + (upper - lower) * this->Part(); }

  /// @param lower, upper  > 0
  double InOrdersBetween(double lower, double upper)
  {
    return std::exp(this->Between(std::log(lower), std::log(upper)));
  }

  int Whole(int lower, int upper) { return lower + int(this->Part() * (upper - lower + 1)); }

  bool Chance(double probability) { return this->Part() < probability; }

  template <class Choice>
  Choice OneOf(const std::vector<Choice>& choices)
  {
    return choices[std::size_t(this->Whole(0, int(choices.size()) - 1))];
  }

private:
  double Part() { return double(this->engine() >> 11) * 0x1p-53; } ///< [0, 1)

  std::mt19937_64 engine;
};

}

#endif
