#ifndef Varimarch_Scene_RegionStatistics_h
#define Varimarch_Scene_RegionStatistics_h

#include <cstdint>
#include <limits>

class vtkImageData;

namespace varimarch
{

/// Statistics of the values of some voxels. Values that are not finite are left out.
struct RegionStatistics
{
  std::int64_t voxels = 0;
  double volumeMm3 = 0.0;
  double mean = 0.0; ///< in units of the data; 0 if there are no voxels
  double standardDeviation = 0.0;
  double smallest = 0.0;
  double largest = 0.0;
};

/// Running sums of values, as differences from an offset that lies among them. Without it, squares
/// of large values would lose the variance to rounding.
class ValueSums
{
public:
  /// An offset that is not finite counts as 0.
  explicit ValueSums(double offset);

  void Add(double value);

  /// Adds the values of other sums, which have the same offset.
  void Join(const ValueSums& other);

  /// @param image  the volume of the voxels
  RegionStatistics Statistics(vtkImageData* image) const;

private:
  double offset;
  std::int64_t count = 0;
  double sum = 0.0;
  double sumOfSquares = 0.0;
  double smallest = std::numeric_limits<double>::infinity();
  double largest = -std::numeric_limits<double>::infinity();
};

}

#endif
