#ifndef Varimarch_Viewer_HistogramBars_h
#define Varimarch_Viewer_HistogramBars_h

#include "Scene/ImageStatistics.h"

#include <cstdint>
#include <vector>

namespace varimarch
{

/// A histogram with bars of equal width. Each bar covers whole bins, so that bars neither flicker
/// when the axis moves nor are empty because they are narrower than the spacing of the values.
class HistogramBars
{
public:
  struct Bar
  {
    double first;
    double last;
    std::int64_t count;
  };

  /// @param leastWidth  of a bar [units of the data]. The statistics must outlive this object.
  HistogramBars(const ImageStatistics& statistics, double leastWidth);

  /// Bars that overlap the range, in order.
  std::vector<Bar> Between(double first, double last) const;

  /// The bar at a value; empty outside the data.
  Bar At(double value) const;

private:
  Bar BarOfIndex(std::int64_t index) const;
  std::int64_t IndexOf(double value) const;

  const ImageStatistics* statistics;
  std::int64_t binsPerBar;
};

}

#endif
