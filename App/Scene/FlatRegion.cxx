#include "Scene/FlatRegion.h"

#include "Scene/SceneCuts.h"
#include "Scene/SliceGrid.h"
#include "Scene/VoxelIndex.h"
#include "Scene/WorldVector.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkImageInterpolator.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace varimarch
{

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

}
