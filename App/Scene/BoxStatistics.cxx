#include "Scene/BoxStatistics.h"

#include "Frame/VolumeGeometry.h"

#include <vtkArrayDispatch.h>
#include <vtkDataArray.h>
#include <vtkDataArrayRange.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace varimarch
{

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

}
