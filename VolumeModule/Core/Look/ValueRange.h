#ifndef Varimarch_Core_Look_ValueRange_h
#define Varimarch_Core_Look_ValueRange_h

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace varimarch
{

/// Values farther from zero count as this, so that the difference of any two is finite.
constexpr double LargestNumber = 1e300;

inline double Limited(double value)
{
  return std::clamp(value, -LargestNumber, LargestNumber);
}

/// Values that are closer than this count as equal, so that no division by a range overflows.
constexpr double SmallestDifference = 1e-290;

/// Values from lower to upper, both included; none if these are reversed.
struct ValueRange
{
  double lower;
  double upper;

  bool IsEmpty() const { return !(this->lower <= this->upper); }
  double Width() const { return this->upper - this->lower; }
  bool Contains(const ValueRange& other) const
  {
    return this->lower <= other.lower && other.upper <= this->upper;
  }
  ValueRange And(const ValueRange& other) const ///< The values that are in both.
  {
    return { std::max(this->lower, other.lower), std::min(this->upper, other.upper) };
  }
  bool operator==(const ValueRange& other) const
  {
    return this->lower == other.lower && this->upper == other.upper;
  }
};

/// The width that a range of values has for computers: not less than the precision of doubles, with
/// thousands of steps. A single value is as wide as it is far from 0, and 0 itself is as wide as 1.
inline double WidthOf(const ValueRange& range)
{
  constexpr double Precision = 1.0 / (std::int64_t(1) << 40);
  const double farthest = std::max(std::abs(range.lower), std::abs(range.upper));
  const double width = range.Width() > 0.0 ? range.Width() : farthest;
  return width > 0.0 ? std::max(width, Precision * farthest) : 1.0;
}

/// True if values reach so far beyond those that matter that equal steps over all of them would not
/// tell these apart, as with a fill value of 1e20.
inline bool ReachFarBeyond(const ValueRange& all, const ValueRange& thatMatter)
{
  constexpr double Far = 4096.0;
  return all.Width() > Far * WidthOf(thatMatter);
}

}

#endif
