#include "Scene/BoxStatistics.h"

#include <vtkArrayDispatch.h>
#include <vtkDataArray.h>
#include <vtkDataArrayRange.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

// First and last voxel along each axis, as in the extents of vtkImageData. An empty range has its
// last voxel before the first.
std::array<int, 6> VoxelsIn(
  const std::array<double, 3>& fromMm, const std::array<double, 3>& toMm, vtkImageData* image)
{
  double corners[2][3];
  image->TransformPhysicalPointToContinuousIndex(fromMm.data(), corners[0]);
  image->TransformPhysicalPointToContinuousIndex(toMm.data(), corners[1]);
  std::array<int, 6> voxels;
  const int* const extent = image->GetExtent();
  for (int axis = 0; axis < 3; ++axis)
  {
    // Clamp to just outside the volume, so that the index fits into an int.
    const auto part = [&](int corner) {
      return std::clamp(corners[corner][axis], extent[2 * axis] - 1.0, extent[2 * axis + 1] + 1.0);
    };
    const double first = std::min(part(0), part(1));
    const double last = std::max(part(0), part(1));
    int begin = int(std::ceil(first - 1e-9));
    int end = int(std::floor(last + 1e-9));
    if (end < begin)
    {
      begin = end = int(std::lround(0.5 * (first + last)));
    }
    voxels[2 * axis] = std::max(begin, extent[2 * axis]);
    voxels[2 * axis + 1] = std::min(end, extent[2 * axis + 1]);
  }
  return voxels;
}

ValueSums SumsOf(const std::array<int, 6>& voxels, vtkImageData* image)
{
  ValueSums sums(0.0);
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  const int* const extent = image->GetExtent();
  const auto indexOf = [&](int i, int j, int k)
  {
    const vtkIdType rows = extent[3] - extent[2] + 1;
    const vtkIdType columns = extent[1] - extent[0] + 1;
    return ((k - extent[4]) * rows + (j - extent[2])) * columns + (i - extent[0]);
  };
  const auto sumUp = [&](auto* array)
  {
    const auto tuples = vtk::DataArrayTupleRange(array);
    const ValueSums none{ double(tuples[indexOf(voxels[0], voxels[2], voxels[4])][0]) };
    sums = tbb::parallel_reduce(
      tbb::blocked_range2d<int>(voxels[4], voxels[5] + 1, voxels[2], voxels[3] + 1), none,
      [&](const tbb::blocked_range2d<int>& part, ValueSums partial)
      {
        for (int k = part.rows().begin(); k != part.rows().end(); ++k)
        {
          for (int j = part.cols().begin(); j != part.cols().end(); ++j)
          {
            for (vtkIdType i = indexOf(voxels[0], j, k); i <= indexOf(voxels[1], j, k); ++i)
            {
              partial.Add(double(tuples[i][0]));
            }
          }
        }
        return partial;
      },
      [](ValueSums a, const ValueSums& b)
      {
        a.Join(b);
        return a;
      });
  };
  if (!vtkArrayDispatch::Dispatch::Execute(scalars, sumUp))
  {
    sumUp(scalars);
  }
  return sums;
}

}

RegionStatistics StatisticsOfBox(
  const std::array<double, 3>& fromMm, const std::array<double, 3>& toMm, vtkImageData* image)
{
  const std::array<int, 6> voxels = VoxelsIn(fromMm, toMm, image);
  if (voxels[1] < voxels[0] || voxels[3] < voxels[2] || voxels[5] < voxels[4])
  {
    return {};
  }
  return SumsOf(voxels, image).Statistics(image);
}

}
