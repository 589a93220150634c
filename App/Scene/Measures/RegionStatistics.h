#ifndef Varimarch_Scene_RegionStatistics_h
#define Varimarch_Scene_RegionStatistics_h

#include "Scene/Model/Scene.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

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

/// Statistics of the voxels whose centres lie in a box along the axes of a volume. A box thinner
/// than the distance of the voxels counts those nearest to its middle.
/// @param fromMm  two opposite corners
/// @param grid    the volume along whose axes the box lies
/// @param voxels  the volume whose voxels are counted, the same or one over it
RegionStatistics StatisticsOfBox(const std::array<double, 3>& fromMm,
  const std::array<double, 3>& toMm, vtkImageData* grid, vtkImageData* voxels);

/// An outline's area times the normal of its plane [mm²]. Zero for fewer than three points.
glm::dvec3 AreaVector(const std::vector<glm::dvec3>& outlineMm);

/// Statistics of the pixels whose centres lie in an outline, by the even-odd rule. If the outline's
/// plane faces along an axis of the volume, the pixels are the voxels of the nearest slice.
/// Otherwise they lie in the plane as far apart as the nearest voxels of the volume, one of them at
/// the middle of the outline's points, and have linearly interpolated values. Pixels outside the
/// volume are left out. The statistics count pixels as voxels.
RegionStatistics StatisticsOfFlatRegion(
  const std::vector<glm::dvec3>& outlineMm, vtkImageData* image);

/// A text as a field of a CSV table, as in RFC 4180: in quotes, and quotes within it doubled.
inline std::string QuotedForCsv(const std::string& text)
{
  std::ostringstream quoted;
  quoted << std::quoted(text, '"', '"');
  return quoted.str();
}

/// Statistics of a scan in each segment of a label map.
/// @param numbers  as LabelMap::image, on the grid of the scan
/// @param count    number of segments
std::vector<RegionStatistics> StatisticsOfSegments(
  vtkImageData* numbers, std::size_t count, vtkImageData* scan);

/// A header line, then a line per segment: "value,name,voxels,volume_ml,mean,standard_deviation,
/// smallest,largest". Numbers are written as in C; the last four are empty without voxels.
std::string CsvOf(
  const std::vector<Segment>& segments, const std::vector<RegionStatistics>& statistics);

}

#endif
