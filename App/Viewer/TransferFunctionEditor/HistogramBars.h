#ifndef Varimarch_Viewer_HistogramBars_h
#define Varimarch_Viewer_HistogramBars_h

#include "Scene/ImageStatistics.h"

#include <cstdint>
#include <vector>

namespace varimarch
{

/// The counts of a volume in bars of equal width. Bars hold whole bins, so that they do not flicker
/// when the axis moves, and none is empty only because it is narrower than the values are apart.
class HistogramBars
{
public:
  struct Bar
  {
    double first;
    double last;
    std::int64_t count;
  };

  /// @param leastWidth  of a bar, in units of the data; the statistics must outlive this
  HistogramBars(const ImageStatistics& statistics, double leastWidth);

  /// Those that reach into the range, in order.
  std::vector<Bar> Between(double first, double last) const;

  /// Empty beyond the data.
  Bar At(double value) const;

private:
  Bar BarOfIndex(std::int64_t index) const;
  std::int64_t IndexOf(double value) const;

  const ImageStatistics* statistics;
  std::int64_t binsPerBar;
};

}

#endif
