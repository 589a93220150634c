#include "Scene/Measures/RegionStatistics.h"

#include "Frame/VolumeGeometry.h"
#include "Scene/Model/SceneCuts.h"
#include "Scene/Model/WorldVector.h"
#include "Scene/Slices/SlicePicture.h"

#include <vtkArrayDispatch.h>
#include <vtkDataArray.h>
#include <vtkDataArrayRange.h>
#include <vtkImageData.h>
#include <vtkImageInterpolator.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <tbb/blocked_range.h>
#include <tbb/blocked_range2d.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace varimarch
{

ValueSums::ValueSums(double offset)
  : offset(std::isfinite(offset) ? offset : 0.0)
{
}

void ValueSums::Add(double value)
{
  if (std::isfinite(value))
  {
    const double difference = value - this->offset;
    ++this->count;
    this->sum += difference;
    this->sumOfSquares += difference * difference;
    this->smallest = std::min(this->smallest, value);
    this->largest = std::max(this->largest, value);
  }
}

void ValueSums::Join(const ValueSums& other)
{
  this->count += other.count;
  this->sum += other.sum;
  this->sumOfSquares += other.sumOfSquares;
  this->smallest = std::min(this->smallest, other.smallest);
  this->largest = std::max(this->largest, other.largest);
}

RegionStatistics ValueSums::Statistics(vtkImageData* image) const
{
  if (this->count == 0)
  {
    return {};
  }
  const double mean = this->sum / double(this->count);
  const double variance = this->sumOfSquares / double(this->count) - mean * mean;
  const double voxelMm3 = std::abs(image->GetIndexToPhysicalMatrix()->Determinant());
  return { this->count, double(this->count) * voxelMm3, this->offset + mean,
    std::sqrt(std::max(variance, 0.0)), this->smallest, this->largest };
}

namespace
{

// Rounding of positions [voxels].
constexpr double PlaceRounding = 1e-9;

/// The first and last index of some voxels along an axis; none if the last lies before the first.
struct IndexRange
{
  int first;
  int last;
};

// A box in the grid that it lies along, and that grid as seen from the voxels to be counted.
class BoxOverVoxels
{
public:
  BoxOverVoxels(const std::array<double, 3>& fromMm, const std::array<double, 3>& toMm,
    vtkImageData* grid, vtkImageData* voxels)
    : gridFromVoxel(
        FromVtk(grid->GetPhysicalToIndexMatrix()) * FromVtk(voxels->GetIndexToPhysicalMatrix()))
    , extent(voxels->GetExtent())
  {
    glm::dvec3 from;
    glm::dvec3 to;
    grid->TransformPhysicalPointToContinuousIndex(fromMm.data(), &from.x);
    grid->TransformPhysicalPointToContinuousIndex(toMm.data(), &to.x);
    this->first = glm::min(from, to);
    this->last = glm::max(from, to);
    this->TakeOneVoxelAtLeast();
  }

  /// Indices along an axis between which all voxels of the box lie, and perhaps others.
  IndexRange Around(int axis) const
  {
    const glm::dmat4 voxelFromGrid = glm::inverse(this->gridFromVoxel);
    double smallest = std::numeric_limits<double>::infinity();
    double largest = -smallest;
    for (int i = 0; i < 8; ++i)
    {
      const glm::dvec4 corner(i & 1 ? this->last.x : this->first.x,
        i >> 1 & 1 ? this->last.y : this->first.y, i >> 2 ? this->last.z : this->first.z, 1.0);
      const double at = (voxelFromGrid * corner)[axis];
      smallest = std::min(smallest, at);
      largest = std::max(largest, at);
    }
    constexpr double Margin = 1e-3; // more than roundings
    return this->Clamped(axis, smallest - Margin, largest + Margin);
  }

  /// The voxels of a row along x whose centres lie in the box.
  IndexRange InRow(int j, int k) const
  {
    const glm::dvec4 start = this->gridFromVoxel * glm::dvec4(0.0, j, k, 1.0);
    const glm::dvec4 step = this->gridFromVoxel[0];
    double from = -std::numeric_limits<double>::infinity();
    double to = -from;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double before = this->first[axis] - PlaceRounding - start[axis];
      const double after = this->last[axis] + PlaceRounding - start[axis];
      if (std::abs(step[axis]) * this->LongestRow() > PlaceRounding)
      {
        from = std::max(from, std::min(before / step[axis], after / step[axis]));
        to = std::min(to, std::max(before / step[axis], after / step[axis]));
      }
      else if (before > 0.0 || after < 0.0)
      {
        return { 0, -1 };
      }
    }
    return this->Clamped(0, from, to);
  }

private:
  // Where the box is thinner than the distance of the voxels, it takes those nearest to its middle.
  void TakeOneVoxelAtLeast()
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      double distance = 0.0;
      for (int along = 0; along < 3; ++along)
      {
        distance += std::abs(this->gridFromVoxel[along][axis]);
      }
      if (this->last[axis] - this->first[axis] < distance - 2.0 * PlaceRounding)
      {
        const double middle = 0.5 * (this->first[axis] + this->last[axis]);
        // Two layers that are equally near would both lie in a closed range.
        this->first[axis] = middle - 0.5 * distance + 2.0 * PlaceRounding;
        this->last[axis] = middle + 0.5 * distance;
      }
    }
  }

  double LongestRow() const { return double(this->extent[1]) - this->extent[0] + 1.0; }

  // Positions may be too large for an int.
  IndexRange Clamped(int axis, double from, double to) const
  {
    const double smallest = this->extent[2 * axis];
    const double largest = this->extent[2 * axis + 1];
    if (!(from <= largest) || !(to >= smallest))
    {
      return { 0, -1 };
    }
    return { int(std::ceil(std::max(from, smallest))), int(std::floor(std::min(to, largest))) };
  }

  glm::dmat4 gridFromVoxel;
  const int* extent;
  glm::dvec3 first;
  glm::dvec3 last;
};

// The number of a voxel among the voxels of a volume.
vtkIdType NumberOf(int i, int j, int k, const int* extent)
{
  const vtkIdType rows = extent[3] - extent[2] + 1;
  const vtkIdType columns = extent[1] - extent[0] + 1;
  return ((k - extent[4]) * rows + (j - extent[2])) * columns + (i - extent[0]);
}

/// The sums of the values in a box, of an array of any type.
struct SummingUp
{
  const BoxOverVoxels& box;
  IndexRange rows;
  IndexRange slices;
  const int* extent;
  ValueSums sums{ 0.0 };

  std::optional<glm::ivec3> VoxelInBox() const
  {
    for (int k = this->slices.first; k <= this->slices.last; ++k)
    {
      for (int j = this->rows.first; j <= this->rows.last; ++j)
      {
        const IndexRange row = this->box.InRow(j, k);
        if (row.first <= row.last)
        {
          return glm::ivec3(row.first, j, k);
        }
      }
    }
    return std::nullopt;
  }

  template <class Array>
  void operator()(Array* array)
  {
    const auto tuples = vtk::DataArrayTupleRange(array);
    const auto valueAt = [&](int i, int j, int k)
    { return double(tuples[NumberOf(i, j, k, this->extent)][0]); };
    // A value of the box as the offset keeps the digits of large values.
    const std::optional<glm::ivec3> inside = this->VoxelInBox();
    if (!inside)
    {
      return;
    }
    const ValueSums none{ valueAt(inside->x, inside->y, inside->z) };
    const auto addPart = [&](const tbb::blocked_range2d<int>& part, ValueSums partial)
    {
      for (int k = part.rows().begin(); k != part.rows().end(); ++k)
      {
        for (int j = part.cols().begin(); j != part.cols().end(); ++j)
        {
          const IndexRange row = this->box.InRow(j, k);
          for (int i = row.first; i <= row.last; ++i)
          {
            partial.Add(valueAt(i, j, k));
          }
        }
      }
      return partial;
    };
    const tbb::blocked_range2d<int> all(
      this->slices.first, this->slices.last + 1, this->rows.first, this->rows.last + 1);
    this->sums = tbb::parallel_reduce(all, none, addPart,
      [](ValueSums a, const ValueSums& b)
      {
        a.Join(b);
        return a;
      });
  }
};

}

RegionStatistics StatisticsOfBox(const std::array<double, 3>& fromMm,
  const std::array<double, 3>& toMm, vtkImageData* grid, vtkImageData* voxels)
{
  const BoxOverVoxels box(fromMm, toMm, grid, voxels);
  const IndexRange rows = box.Around(1);
  const IndexRange slices = box.Around(2);
  if (rows.last < rows.first || slices.last < slices.first)
  {
    return {};
  }
  SummingUp summing{ box, rows, slices, voxels->GetExtent() };
  vtkDataArray* const scalars = voxels->GetPointData()->GetScalars();
  if (!vtkArrayDispatch::Dispatch::Execute(scalars, summing))
  {
    summing(scalars);
  }
  return summing.sums.Statistics(voxels);
}

namespace
{

glm::dvec3 MiddleOfPoints(const std::vector<glm::dvec3>& points)
{
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& point : points)
  {
    sum += point;
  }
  return sum / double(points.size());
}

/// Pixels in the plane of a region: pixel (0, 0) is at `origin`.
struct PixelPlane
{
  glm::dvec3 originMm;
  glm::dvec3 columnMm; ///< from a pixel to the next of its row
  glm::dvec3 rowMm;

  /// A point of the plane in units of pixels.
  glm::dvec2 PlaceOf(const glm::dvec3& pointMm) const
  {
    const glm::dvec3 from = pointMm - this->originMm;
    return { glm::dot(from, this->columnMm) / glm::dot(this->columnMm, this->columnMm),
      glm::dot(from, this->rowMm) / glm::dot(this->rowMm, this->rowMm) };
  }
};

// The axis of the volume that a normal lies along.
std::optional<int> AxisAlong(const glm::dvec3& normal, vtkImageData* image)
{
  constexpr double SmallestCosine = 0.9999; // 0.8 degrees
  for (int axis = 0; axis < 3; ++axis)
  {
    double cosine = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      cosine += image->GetDirectionMatrix()->GetElement(i, axis) * normal[i];
    }
    if (std::abs(cosine) > SmallestCosine)
    {
      return axis;
    }
  }
  return std::nullopt;
}

// The voxels of the slice nearest to a point.
PixelPlane SliceThrough(const glm::dvec3& middleMm, int axis, vtkImageData* image)
{
  glm::dvec3 index(0.0);
  index[axis] = std::round(VoxelIndexOf(middleMm, image)[axis]);
  const auto pointAt = [image](const glm::dvec3& at)
  {
    glm::dvec3 point;
    image->TransformContinuousIndexToPhysicalPoint(&at.x, &point.x);
    return point;
  };
  const auto step = [&](int along)
  {
    glm::dvec3 next = index;
    next[along] += 1.0;
    return pointAt(next) - pointAt(index);
  };
  return { pointAt(index), step((axis + 1) % 3), step((axis + 2) % 3) };
}

PixelPlane ObliquePlane(const glm::dvec3& middleMm, const glm::dvec3& normal, vtkImageData* image)
{
  const double* const spacing = image->GetSpacing();
  const double pixelMm = *std::min_element(spacing, spacing + 3);
  const glm::dvec3 aside = std::abs(normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 column = glm::normalize(glm::cross(aside, normal));
  return { middleMm, pixelMm * column, pixelMm * glm::cross(normal, column) };
}

// First and last pixel along a direction, within the volume.
std::array<double, 2> PixelsAlong(const std::vector<glm::dvec2>& outline, int coordinate,
  const PixelPlane& plane, vtkImageData* image)
{
  const glm::dvec3 step = coordinate == 0 ? plane.columnMm : plane.rowMm;
  const double length = glm::length(step);
  const auto [nearest, farthest] = ReachAlong(NumbersOf(step / length), image);
  const glm::dvec3 middle = VectorOf(MiddleOf(image));
  const double offset = plane.PlaceOf(middle)[coordinate];
  const auto [first, last] = std::minmax_element(outline.begin(), outline.end(),
    [&](const glm::dvec2& a, const glm::dvec2& b) { return a[coordinate] < b[coordinate]; });
  return { std::ceil(std::max((*first)[coordinate], offset + nearest / length - 1.0)),
    std::floor(std::min((*last)[coordinate], offset + farthest / length + 1.0)) };
}

/// The pixels of a plane that lie in an outline.
class RegionPixels
{
public:
  RegionPixels(
    const std::vector<glm::dvec3>& outlineMm, const PixelPlane& plane, vtkImageData* image)
    : extent(image->GetExtent())
  {
    for (const glm::dvec3& point : outlineMm)
    {
      this->outline.push_back(plane.PlaceOf(point));
    }
    this->columns = PixelsAlong(this->outline, 0, plane, image);
    this->rows = PixelsAlong(this->outline, 1, plane, image);
    this->origin = VoxelIndexOf(plane.originMm, image);
    this->column = VoxelIndexOf(plane.originMm + plane.columnMm, image) - this->origin;
    this->row = VoxelIndexOf(plane.originMm + plane.rowMm, image) - this->origin;
    this->interpolator->SetInterpolationModeToLinear();
    this->interpolator->SetComponentCount(1); // volumes of colours have several
    this->interpolator->Initialize(image);
  }

  ValueSums Sums(double offset) const
  {
    const auto count = std::int64_t(std::max(this->rows[1] - this->rows[0] + 1.0, 0.0));
    return tbb::parallel_reduce(
      tbb::blocked_range<std::int64_t>(0, count), ValueSums(offset),
      [this](const tbb::blocked_range<std::int64_t>& part, ValueSums sums)
      {
        for (std::int64_t i = part.begin(); i != part.end(); ++i)
        {
          this->AddRow(this->rows[0] + double(i), sums);
        }
        return sums;
      },
      [](ValueSums a, const ValueSums& b)
      {
        a.Join(b);
        return a;
      });
  }

private:
  // The places at which the outline crosses a row, in ascending order.
  std::vector<double> Crossings(double y) const
  {
    std::vector<double> crossings;
    for (std::size_t i = 0; i < this->outline.size(); ++i)
    {
      const glm::dvec2& from = this->outline[i];
      const glm::dvec2& to = this->outline[(i + 1) % this->outline.size()];
      if ((from.y <= y) != (to.y <= y))
      {
        crossings.push_back(from.x + (y - from.y) / (to.y - from.y) * (to.x - from.x));
      }
    }
    std::sort(crossings.begin(), crossings.end());
    return crossings;
  }

  void AddRow(double y, ValueSums& sums) const
  {
    const std::vector<double> crossings = this->Crossings(y);
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    {
      const double first = std::ceil(std::max(crossings[i], this->columns[0]));
      const double last = std::min(crossings[i + 1], this->columns[1]);
      // Far from the origin, a number may have no successor.
      for (std::int64_t pixel = 0; double(pixel) <= last - first; ++pixel)
      {
        const double x = first + double(pixel);
        this->AddPixel(this->origin + x * this->column + y * this->row, sums);
      }
    }
  }

  void AddPixel(glm::dvec3 index, ValueSums& sums) const
  {
    constexpr double Rounding = 1e-6; // voxels
    for (int axis = 0; axis < 3; ++axis)
    {
      const double nearest = std::round(index[axis]);
      index[axis] = std::abs(index[axis] - nearest) < Rounding ? nearest : index[axis];
    }
    if (IsWithin(index, this->extent))
    {
      double value;
      this->interpolator->InterpolateIJK(&index.x, &value);
      sums.Add(value);
    }
  }

  const int* extent;
  std::vector<glm::dvec2> outline; ///< in pixels
  std::array<double, 2> columns;   ///< first and last
  std::array<double, 2> rows;
  glm::dvec3 origin; ///< index of pixel (0, 0)
  glm::dvec3 column; ///< difference of the indices of two pixels beside each other
  glm::dvec3 row;
  vtkNew<vtkImageInterpolator> interpolator;
};

}

glm::dvec3 AreaVector(const std::vector<glm::dvec3>& outlineMm)
{
  glm::dvec3 doubled(0.0);
  for (std::size_t i = 1; i + 1 < outlineMm.size(); ++i)
  {
    doubled += glm::cross(outlineMm[i] - outlineMm[0], outlineMm[i + 1] - outlineMm[0]);
  }
  return 0.5 * doubled;
}

RegionStatistics StatisticsOfFlatRegion(
  const std::vector<glm::dvec3>& outlineMm, vtkImageData* image)
{
  const glm::dvec3 area = AreaVector(outlineMm);
  if (!(glm::length(area) > 0.0) || !std::isfinite(glm::length(area)))
  {
    return {};
  }
  const glm::dvec3 normal = glm::normalize(area);
  const glm::dvec3 middle = MiddleOfPoints(outlineMm);
  const std::optional<int> axis = AxisAlong(normal, image);
  const PixelPlane plane =
    axis ? SliceThrough(middle, *axis, image) : ObliquePlane(middle, normal, image);
  // A value of the volume as the offset keeps the digits of large values.
  const double offset = image->GetPointData()->GetScalars()->GetComponent(0, 0);
  return RegionPixels(outlineMm, plane, image).Sums(offset).Statistics(image);
}

namespace
{

constexpr double Mm3PerMl = 1000.0;

}

std::vector<RegionStatistics> StatisticsOfSegments(
  vtkImageData* numbers, std::size_t count, vtkImageData* scan)
{
  const auto* const segments = static_cast<const unsigned char*>(numbers->GetScalarPointer());
  vtkDataArray* const scalars = scan->GetPointData()->GetScalars();
  double range[2];
  scalars->GetFiniteRange(range, 0);
  // The first element counts the voxels in no segment.
  const std::vector<ValueSums> none(count + 1, ValueSums(0.5 * range[0] + 0.5 * range[1]));
  tbb::combinable<std::vector<ValueSums>> sumsOfThreads([&] { return none; });
  const auto sumUp = [&](auto* array)
  {
    const auto tuples = vtk::DataArrayTupleRange(array);
    tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, tuples.size(), 65536),
      [&](const tbb::blocked_range<vtkIdType>& voxels)
      {
        std::vector<ValueSums>& sums = sumsOfThreads.local();
        for (vtkIdType i = voxels.begin(); i != voxels.end(); ++i)
        {
          sums[segments[i]].Add(double(tuples[i][0]));
        }
      });
  };
  if (!vtkArrayDispatch::Dispatch::Execute(scalars, sumUp))
  {
    sumUp(scalars);
  }
  std::vector<ValueSums> all = none;
  sumsOfThreads.combine_each(
    [&](const std::vector<ValueSums>& sums)
    {
      for (std::size_t i = 0; i < all.size(); ++i)
      {
        all[i].Join(sums[i]);
      }
    });
  std::vector<RegionStatistics> statistics;
  for (std::size_t i = 1; i < all.size(); ++i)
  {
    statistics.push_back(all[i].Statistics(scan));
  }
  return statistics;
}

std::string CsvOf(
  const std::vector<Segment>& segments, const std::vector<RegionStatistics>& statistics)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "value,name,voxels,volume_ml,mean,standard_deviation,smallest,largest\n";
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    const RegionStatistics& region = statistics[i];
    text << segments[i].value << ',' << QuotedForCsv(segments[i].name) << ',' << region.voxels
         << ',' << region.volumeMm3 / Mm3PerMl;
    if (region.voxels > 0)
    {
      text << ',' << region.mean << ',' << region.standardDeviation << ',' << region.smallest << ','
           << region.largest << '\n';
    }
    else
    {
      text << ",,,,\n";
    }
  }
  return text.str();
}

}
